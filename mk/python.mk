# The Python module, importable from $(BUILD)/python. `pip install .` packs the same files (meson.build).
#
# PYTHON_LIBRARY=own puts the library beside the module, which finds it there; system: the machine has it.

PYTHON ?= python3
PYTHON_LIBRARY ?= own
MODULE := $(BUILD)/python/manylight
MODULE_FILES := $(patsubst python/%,$(BUILD)/python/%,$(wildcard python/manylight/*.py python/manylight/py.typed))
MODULE_LIBRARY := $(if $(filter own,$(PYTHON_LIBRARY)),$(MODULE)/$(SHARED_NAME) $(if $(PLUGINS),$(MODULE)/$(PLUGIN_NAME)))
PYTHON_INCLUDE = $(shell $(PYTHON) -c 'import sysconfig; print(sysconfig.get_path("include"))')
# The interface of Python 3.9 alone, which later versions have too.
MODULE_FLAGS = -std=c11 -fPIC -Isrc/library -isystem $(PYTHON_INCLUDE) -DPy_LIMITED_API=0x03090000 $(CFLAGS)
ORIGIN := -Wl,-rpath,'$$ORIGIN'

.PHONY: python
python: $(MODULE_FILES) $(MODULE)/_cffi.abi3.so

$(BUILD)/python/%: python/%
	@mkdir -p $(@D)
	@cp $< $@

$(BUILD)/python/_cffi.c: python/make_cffi.py src/library/manylight.h
	@mkdir -p $(@D)
	$(say) GEN $@
	$(Q)$(PYTHON) $^ $@ >/dev/null

$(MODULE)/_cffi.abi3.so: $(BUILD)/python/_cffi.c $(MODULE_LIBRARY)
	@mkdir -p $(@D)
	$(say) CC $@
	$(Q)$(CC) $(MODULE_FLAGS) -shared -o $@ $< $(LDFLAGS) $(if $(MODULE_LIBRARY),$(ORIGIN)) -L$(SHARED_FOLDER) -lmanylight

# A process that has loaded the old file keeps it.
$(MODULE)/$(SHARED_NAME): $(SHARED)
	@mkdir -p $(@D)
	@cp $< $@.new && mv $@.new $@

$(MODULE)/$(PLUGIN_NAME): $(PLUGIN)
	@mkdir -p $(@D)
	@cp $< $@.new && mv $@.new $@

$(BUILD)/test/test_python $(BUILD)/test/test_table: | $(SHARED)
