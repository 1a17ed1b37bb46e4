# Below PREFIX lies a list of what was installed, also by versions before: uninstall removes these files, the list, and
# folders of the program that are empty then.
SHARE := share/manylight
DOC := share/doc/manylight
INSTALLED := $(SHARE)/installed

# Made of the help of the program: man pages, and completions for bash.
MANUAL := $(BUILD)/manual

install: all lib $(FINDERS)
	@echo "  INST $(DESTDIR)$(PREFIX)"
	@set -e; root="$(DESTDIR)$(PREFIX)"; install -d "$$root/$(SHARE)"; \
	put_as() { install -D -m $$2 "$$3" "$$root/$$1"; echo "$$1" >> "$$root/$(INSTALLED)"; }; \
	put() { folder=$$1; mode=$$2; shift 2; for file; do put_as "$$folder/$${file##*/}" $$mode "$$file"; done; }; \
	rm -rf $(MANUAL); docs/manual ./manylight $(MANUAL) $(DATE); \
	put bin 755 manylight; \
	put $(DOC) 644 LICENSE; \
	put include 644 src/library/manylight.h; \
	put $(LIBDIR) 755 $(SHARED); \
	$(if $(PLUGINS),put $(LIBDIR)/manylight 755 $(PLUGIN);) \
	link() { ln -sf "$$1" "$$root/$(LIBDIR)/$$2"; echo "$(LIBDIR)/$$2" >> "$$root/$(INSTALLED)"; }; \
	link $(notdir $(SHARED)) $(SHARED_NAME); link $(SHARED_NAME) libmanylight.so; \
	put $(LIBDIR)/pkgconfig 644 $(SHARED_FOLDER)/manylight.pc; \
	put $(LIBDIR)/cmake/manylight 644 $(SHARED_FOLDER)/manylightConfig.cmake $(SHARED_FOLDER)/manylightConfigVersion.cmake; \
	put $(DOC)/examples 644 examples/*.c; \
	put share/man/man1 644 $(MANUAL)/*.1; \
	put_as share/bash-completion/completions/manylight 644 $(MANUAL)/manylight.bash; \
	put share/applications 644 desktop/*.desktop; \
	put share/metainfo 644 desktop/*.metainfo.xml; \
	put share/thumbnailers 644 desktop/*.thumbnailer; \
	put share/icons/hicolor/scalable/apps 644 desktop/*.svg; \
	put $(SHARE)/scenes 644 scenes/*.glb scenes/*.hdr; \
	put $(SHARE)/scenes/failures 644 scenes/failures/*.glb; \
	sort -u -o "$$root/$(INSTALLED)" "$$root/$(INSTALLED)"

uninstall:
	@echo "  RM   $(DESTDIR)$(PREFIX)"
	@cd "$(DESTDIR)$(PREFIX)" && test -f $(INSTALLED) || { echo "nothing to uninstall: $(INSTALLED) is not there"; exit 1; }
	@set -e; cd "$(DESTDIR)$(PREFIX)"; while read -r file; do rm -f "$$file"; done < $(INSTALLED); rm $(INSTALLED); \
	for folder in $(SHARE) $(DOC) $(LIBDIR)/manylight $(LIBDIR)/cmake/manylight; do test ! -d $$folder || find $$folder -depth -type d -empty -delete; done
