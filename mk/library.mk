# libmanylight.so: the layers below the viewer and the subcommands, behind src/library/manylight.h.

.PHONY: lib

# The number of MANYLIGHT_ABI in the header.
ABI := $(shell sed -n 's/^.define MANYLIGHT_ABI //p' src/library/manylight.h)
LIBDIR ?= lib

SHARED_FOLDER := $(BUILD)/lib
SHARED_NAME := libmanylight.so.$(ABI)
SHARED := $(SHARED_FOLDER)/libmanylight.so.$(VERSION)
SHARED_MAP := src/library/manylight.map
# Videos start ffmpeg and ignore SIGPIPE, which is the process's.
SHARED_OBJECTS := $(filter-out $(BUILD)/src/lab/% $(BUILD)/src/apps/% $(BUILD)/src/viewer/% $(BUILD)/src/base/file/video_file.o,$(OBJECTS))
SHARED_LIBS := $(PICTURE_LIBS) $(EMBREE) -ldraco -lmeshoptimizer -ldl -lpthread -lm

lib: $(SHARED)

# A folder of the compiler's and the loader's names, as an installed one.
$(SHARED): $(SHARED_OBJECTS) $(SHARED_MAP) | $(PLUGINS)
	@mkdir -p $(@D)
	$(say) LINK $@
	$(Q)$(CXX) $(CFLAGS) $(LDFLAGS) -shared -Wl,-soname,$(SHARED_NAME) -Wl,--version-script,$(SHARED_MAP) -Wl,--as-needed \
	    $(if $(findstring sanitize,$(CFLAGS)),,-Wl,-z,defs) -o $@ $(SHARED_OBJECTS) $(SHARED_LIBS)
	@ln -sf $(@F) $(@D)/$(SHARED_NAME)
	@ln -sf $(SHARED_NAME) $(@D)/libmanylight.so

# What other builds find the library by. PREFIX is the one that it is installed for.
FINDERS := $(addprefix $(SHARED_FOLDER)/,manylight.pc manylightConfig.cmake manylightConfigVersion.cmake)
UP := $(shell printf '%s' '$(LIBDIR)' | sed -E 's,[^/]+,..,g')

$(FINDERS): $(SHARED_FOLDER)/%: src/library/%.in FORCE
	@mkdir -p $(@D)
	@sed -e 's,@PREFIX@,$(PREFIX),' -e 's,@LIBDIR@,$(LIBDIR),' -e 's,@VERSION@,$(VERSION),' -e 's,@ABI@,$(ABI),' \
	    -e 's,@UP@,$(UP),' $< > $@.new
	$(keep)
