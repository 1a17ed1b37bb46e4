# Below PREFIX lies a list of what was installed, also by versions before: uninstall removes these files, the list, and
# folders of the program that are empty then.
SHARE := share/manylight
DOC := share/doc/manylight
INSTALLED := $(SHARE)/installed

install: all lib $(FINDERS)
	@echo "  INST $(DESTDIR)$(PREFIX)"
	@set -e; root="$(DESTDIR)$(PREFIX)"; install -d "$$root/$(SHARE)"; \
	put() { folder=$$1; mode=$$2; shift 2; for file; do \
	    install -D -m $$mode "$$file" "$$root/$$folder/$${file##*/}"; \
	    echo "$$folder/$${file##*/}" >> "$$root/$(INSTALLED)"; done; }; \
	put bin 755 manylight; \
	put $(DOC) 644 LICENSE; \
	put include 644 src/library/manylight.h; \
	put $(LIBDIR) 755 $(SHARED); \
	link() { ln -sf "$$1" "$$root/$(LIBDIR)/$$2"; echo "$(LIBDIR)/$$2" >> "$$root/$(INSTALLED)"; }; \
	link $(notdir $(SHARED)) $(SHARED_NAME); link $(SHARED_NAME) libmanylight.so; \
	put $(LIBDIR)/pkgconfig 644 $(SHARED_FOLDER)/manylight.pc; \
	put $(LIBDIR)/cmake/manylight 644 $(SHARED_FOLDER)/manylightConfig.cmake $(SHARED_FOLDER)/manylightConfigVersion.cmake; \
	put $(DOC)/examples 644 examples/*.c; \
	put $(SHARE)/scenes 644 scenes/*.glb scenes/*.hdr; \
	put $(SHARE)/scenes/failures 644 scenes/failures/*.glb; \
	sort -u -o "$$root/$(INSTALLED)" "$$root/$(INSTALLED)"

uninstall:
	@echo "  RM   $(DESTDIR)$(PREFIX)"
	@cd "$(DESTDIR)$(PREFIX)" && test -f $(INSTALLED) || { echo "nothing to uninstall: $(INSTALLED) is not there"; exit 1; }
	@set -e; cd "$(DESTDIR)$(PREFIX)"; while read -r file; do rm -f "$$file"; done < $(INSTALLED); rm $(INSTALLED); \
	for folder in $(SHARE) $(DOC) $(LIBDIR)/cmake/manylight; do test ! -d $$folder || find $$folder -depth -type d -empty -delete; done
