# The Python module, importable from $(BUILD)/python. `pip install .` packs the same files (meson.build).
#
# PYTHON_LIBRARY=own puts libmanylight.so.0 beside the module, where it finds it; system: the machine has it.

PYTHON ?= python3
PYTHON_LIBRARY ?= own
comma := ,
MODULE := $(BUILD)/python/manylight
MODULE_FILES := $(patsubst python/%,$(BUILD)/python/%,$(wildcard python/manylight/*.py python/manylight/py.typed))
# The interface of Python 3.9 alone, which later versions have too.
MODULE_FLAGS = -std=c11 -fPIC -Isrc/library -isystem "$$($(PYTHON) -c 'import sysconfig; print(sysconfig.get_path("include"))')" \
    -DPy_LIMITED_API=0x03090000 $(CFLAGS)

.PHONY: python
python: $(MODULE_FILES) $(MODULE)/_cffi.abi3.so

$(BUILD)/python/%: python/%
	@mkdir -p $(@D)
	@cp $< $@

$(BUILD)/python/_cffi.c: python/make_cffi.py src/library/manylight.h
	@mkdir -p $(@D)
	$(say) GEN $@
	$(Q)$(PYTHON) $^ $@ >/dev/null

OWN_LIBRARY := $(if $(filter own,$(PYTHON_LIBRARY)),$(MODULE)/libmanylight.so.0)
$(MODULE)/_cffi.abi3.so: $(BUILD)/python/_cffi.c $(OWN_LIBRARY)
	@mkdir -p $(@D)
	$(say) CC $@
	$(Q)$(CC) $(MODULE_FLAGS) -shared -o $@ $< $(LDFLAGS) $(if $(OWN_LIBRARY),-Wl$(comma)-rpath$(comma)'$$ORIGIN') \
	    -L$(BUILD) -l:libmanylight.so.0

$(MODULE)/libmanylight.so.0: $(SHARED_LIBRARY)
	@mkdir -p $(@D)
	@cp $< $@
