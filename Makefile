# manylight: make | lib | demo | test | test-long | deps | install | uninstall | clean
#
# mk/test.mk has the targets of tests, checks and the bundle; bench/Makefile those of the benchmark.
#
# A plain `make` only builds ./manylight. `make demo` and `make test` first install what is missing.

CC ?= cc
CXX ?= c++
PREFIX ?= /usr/local
# Parts to build without, of PARTS: make WITHOUT="viewer lab techniques/lightcuts"
WITHOUT ?=
BUILD ?= build
CFLAGS ?= -O2 -g
CXXFLAGS ?= $(CFLAGS)
# Warnings are errors in CI alone: a newer compiler has more of them.
WERROR ?=

# The binary of the default build lies at the top; other builds keep theirs in their folder.
BINARY ?= manylight

# The date stands in man pages.
VERSION := 0.1
DATE := 2026-11-27
COMMIT := $(shell git describe --always --dirty 2>/dev/null || echo unknown)

# The commands are shown by make V=1.
Q := $(if $(V),,@)
say = @$(if $(V),:,printf '  %-4s %s\n')

# --- what it is made of ---------------------------------------------------------------------------

# OpenImageIO reads and writes the pictures that smaller libraries do not. PICTURES=small leaves it out, for `make bundle`.
PICTURES ?= openimageio
# What all else does without. The default technique, the baseline and their refinement stay, and of the viewer the one
# file that tests of files and fuzzers use.
TECHNIQUES := $(patsubst src/%/,%,$(sort $(wildcard src/techniques/*/)))
PARTS := caustics lab library video viewer volume $(filter-out %/clustered %/instant-radiosity %/unshadowed,$(TECHNIQUES))
$(if $(filter-out $(PARTS),$(WITHOUT)),$(error WITHOUT takes $(PARTS)))
FILES_OF_viewer := src/apps/view.c $(filter-out %/session.c,$(shell find src/viewer -name '*.c*'))
FILES_OF_volume := src/passes/volume/% src/passes/volumes.c src/passes/volume_points.c src/techniques/volume.c \
    src/techniques/volume_box.c src/techniques/imperfect-volume/% src/renderer/ambient_occlusion.c
FILES_OF_caustics := src/passes/caustics/% src/renderer/caustics_passes.c
FILES_OF_video := src/base/file/video_file.c
LEFT_OUT := src/base/file/openimageio/% $(foreach part,$(WITHOUT),$(or $(FILES_OF_$(part)),src/$(part)/%))
VIEWER := $(filter-out $(WITHOUT),viewer)

# Floors are folders of src/, rooms folders of theirs, to any depth; src/main.c is no floor's. Shaders
# lie beside the C that draws with them; what many of them include lies in glsl/.
SOURCES := $(filter-out $(LEFT_OUT),$(sort $(shell find src -mindepth 2 -name '*.c')))
BRIDGES := $(filter-out $(LEFT_OUT),$(sort $(shell find src -mindepth 2 -name '*.cpp')))
SHADERS := $(filter-out $(LEFT_OUT),$(sort $(shell find glsl -type f -name '[!.]*') \
    $(shell find src -name '*.vert' -o -name '*.geom' -o -name '*.frag' -o -name '*.comp' -o -name '*.glsl')))
SCENE_TOOL_SOURCES := $(sort $(shell find scenes -name '*.c'))
SCENE_TOOL := $(BUILD)/scenes/make_scenes
SCENE_NAMES := atrium cornell-box three-lights cornell-animal sphere metaballs moving-spot door creatures character table gloss materials roughness plant courtyard hall vase ring pawns gem window
SKY_NAMES := day overcast
SCENE_FOLDER := scenes
SCENES := $(BUILD)/scenes/made

# Debian's packages; OpenGL itself (libEGL, libOSMesa) is opened at run time. "?": where the release has it.
PACKAGES := gcc g++ make pkgconf git libegl-dev libegl1 libgl-dev libgl1-mesa-dri libosmesa6? \
    libglfw3-dev libtinygltf-dev libstb-dev nlohmann-json3-dev libdraco-dev libmeshoptimizer-dev libopenimageio-dev libcglm-dev \
    libopenexr-dev libpng-dev libjpeg-dev libwebp-dev \
    libembree-dev libimgui-dev fonts-dejavu-core libcmocka-dev libx11-dev gnuplot-nox xvfb xauth xdotool python3-dev python3-cffi python3-numpy

PKG := cglm OpenEXR $(if $(VIEWER),imgui glfw3)
INCLUDES := -Isrc -Iglsl -I$(BUILD)/include
WARNINGS := -Wall -Wextra $(WERROR)
# One set of objects serves the program and libmanylight.so. The bundle's tests use a library that shows all symbols.
VISIBILITY ?= hidden
LIBRARY_FLAGS := -fPIC -fvisibility=$(VISIBILITY)
C_FLAGS = -std=c11 $(LIBRARY_FLAGS) -DCGLM_ALL_UNALIGNED $(WARNINGS) -Wstrict-prototypes -Wmissing-prototypes $(INCLUDES) $(PKG_CFLAGS) $(CFLAGS)
CXX_FLAGS = -std=c++17 $(LIBRARY_FLAGS) $(WARNINGS) $(INCLUDES) $(PKG_CFLAGS) $(CXXFLAGS)
# System headers: their warnings are not ours.
PKG_CFLAGS := $(patsubst -I%,-isystem %,$(shell pkg-config --cflags $(PKG) $(if $(filter small,$(PICTURES)),,OpenImageIO) 2>/dev/null))
PICTURE_LIBS := -lOpenEXRCore -lpng16 -ljpeg -lwebp
# Embree 4 where the compiler finds its header, as src/reference/scene/embree.h.
EMBREE := -lembree$(shell $(CC) -E -include embree4/rtcore.h -x c /dev/null >/dev/null 2>&1 && echo 4 || echo 3)
LIBS := $(if $(VIEWER),$(shell pkg-config --libs imgui glfw3 2>/dev/null)) $(PICTURE_LIBS) $(EMBREE) -ldraco -lmeshoptimizer -lstdc++ -ldl -lpthread -lm

EMBEDDED := $(BUILD)/glsl_embedded.o $(BUILD)/bounds_embedded.o
BOUNDS := $(filter-out $(LEFT_OUT),$(sort $(wildcard src/techniques/*/bounds.csv)))
OBJECTS := $(SOURCES:%.c=$(BUILD)/%.o) $(BRIDGES:%.cpp=$(BUILD)/%.o) $(EMBEDDED)
GUESTS := $(BUILD)/test/guests
MAIN_OBJECT := $(BUILD)/src/main.o
LIBRARY := $(BUILD)/libmanylight.a

# The bridge to OpenImageIO is opened at run time (src/base/file/image_plugin.h). It takes copies of a few objects of
# the library. Links to it lie beside each program of a build, where the program looks first.
PLUGIN_NAME := libmanylight-openimageio.so
PLUGIN := $(BUILD)/openimageio/$(PLUGIN_NAME)
PLUGIN_OBJECTS := $(patsubst %.cpp,$(BUILD)/%.o,$(sort $(wildcard src/base/file/openimageio/*.cpp)))
PLUGIN_LINKS := $(addsuffix /$(PLUGIN_NAME),$(sort $(patsubst %/,%,$(dir $(BINARY))) \
    $(BUILD) $(BUILD)/check $(BUILD)/lib $(BUILD)/test $(GUESTS) $(BUILD)/scenes))
PLUGINS := $(if $(filter small,$(PICTURES)),,$(PLUGIN) $(PLUGIN_LINKS))

.PHONY: all demo deps install uninstall clean FORCE
.DELETE_ON_ERROR:
.SECONDARY:

all: $(BINARY) $(SCENES)

$(BINARY): $(MAIN_OBJECT) $(LIBRARY) | $(PLUGINS)
	$(say) LINK $@
	$(Q)$(CXX) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(LIBS)

$(LIBRARY): $(OBJECTS) $(BUILD)/include/parts.h
	@rm -f $@
	$(say) AR $@
	$(Q)ar rcs $@ $(OBJECTS)

$(PLUGIN): $(PLUGIN_OBJECTS) $(LIBRARY)
	@mkdir -p $(@D)
	$(say) LINK $@
	$(Q)$(CXX) $(CFLAGS) $(LDFLAGS) -shared -Wl,--exclude-libs,ALL -Wl,--as-needed -o $@ $^ \
	    $(shell pkg-config --libs OpenImageIO) -ldl -lpthread -lm

$(PLUGIN_LINKS): | $(PLUGIN)
	@mkdir -p $(@D)
	@ln -srf $(PLUGIN) $@

$(BUILD)/%.o: %.c | $(BUILD)/include/version.h $(BUILD)/include/sources.h $(BUILD)/include/parts.h
	@mkdir -p $(@D)
	$(say) CC $@
	$(Q)$(CC) $(C_FLAGS) -MMD -MP -c -o $@ $<

$(BUILD)/%.o: %.cpp | $(BUILD)/include/version.h
	@mkdir -p $(@D)
	$(say) CXX $@
	$(Q)$(CXX) $(CXX_FLAGS) -MMD -MP -c -o $@ $<

# Rewritten only when they say something new, so that a build without changes does nothing. What
# cached pictures depend on: the sources of the path tracer, and all that the renderer is made of.
sum = $$(find $(1) -type f | LC_ALL=C sort | xargs cat | cksum | tr ' ' -)
keep = @cmp -s $@ $@.new && rm $@.new || mv $@.new $@

$(BUILD)/include/version.h: FORCE
	@mkdir -p $(@D)
	@printf '#define MANYLIGHT_VERSION "%s"\n#define MANYLIGHT_COMMIT "%s"\n#define MANYLIGHT_LIBDIR "%s"\n' \
	    $(VERSION) $(COMMIT) $(LIBDIR) > $@.new
	$(keep)

$(BUILD)/include/sources.h: FORCE
	@mkdir -p $(@D)
	@printf '#define MANYLIGHT_TRACER "%s"\n#define MANYLIGHT_SOURCES "%s"\n' \
	    "$(call sum,src/reference src/scene)" "$(call sum,src glsl)" > $@.new
	$(keep)

# The parts of this build: IF_VIEWER(a, b) is a, or b without the viewer; TECHNIQUES lists the folders of techniques.
$(BUILD)/include/parts.h: FORCE
	@mkdir -p $(@D)
	@{ $(foreach part,caustics lab video viewer volume,echo '#define IF_$(shell echo $(part) | tr a-z A-Z)(yes, no) $(if $(filter $(part),$(WITHOUT)),no,yes)';) \
	   printf '#define TECHNIQUES(X)'; \
	   printf ' X(%s)' $(subst -,_,$(notdir $(filter-out $(WITHOUT) $(if $(filter volume,$(WITHOUT)),%/imperfect-volume),$(TECHNIQUES)))); echo; } > $@.new
	$(keep)
FORCE:

# Rewritten only when a shader came, went or moved: a moved file may be older than what was made of it.
$(BUILD)/shaders.list: FORCE
	@mkdir -p $(@D)
	@printf '%s\n' $(SHADERS) > $@.new
	@cmp -s $@ $@.new && rm $@.new || mv $@.new $@

# Text as C strings.
quote = sed -e 's/\\/\\\\/g' -e 's/"/\\"/g' -e 's/^/"/' -e 's/$$/\\n"/'

# Each shader file becomes one string, under its path below glsl/, src/ or the guests of the tests;
# gl/glsl.c reads the table.
$(BUILD)/glsl_embedded.c: $(SHADERS)
$(BUILD)/glsl_embedded.c $(GUESTS)/glsl_embedded.c: $(BUILD)/shaders.list Makefile
	@mkdir -p $(@D)
	@{ echo '#include "gl/glsl_embedded.h"'; \
	   echo 'const struct glsl_file glsl_embedded[] = {'; \
	   for f in $(filter-out %.list Makefile,$^); do \
	       name=$${f#glsl/}; name=$${name#src/}; \
	       echo "{\"$${name#test/guests/}\","; \
	       $(quote) $$f; \
	       echo '},'; \
	   done; \
	   echo '{0, 0}};'; } > $@

# The rows of all techniques, each behind the technique's name.
$(BUILD)/bounds_embedded.c: $(BOUNDS) $(BUILD)/include/parts.h Makefile
	@mkdir -p $(@D)
	@{ echo 'extern const char failure_bounds[];'; echo 'const char failure_bounds[] ='; \
	   awk '{ sub(".*techniques/", "", FILENAME); sub("/.*", "", FILENAME); print FILENAME "," $$0 }' $(BOUNDS) | \
	   $(quote); echo ';'; } > $@

$(BUILD)/%_embedded.o: $(BUILD)/%_embedded.c
	$(say) CC $@
	$(Q)$(CC) $(C_FLAGS) -c -o $@ $<

# Chroots of `make systems` have files of this name, too.
-include $(shell find $(BUILD) -path $(BUILD)/systems -prune -o -type f -name '*.d' -print 2>/dev/null)

# --- scenes ---------------------------------------------------------------------------------------

# Every build runs its own tool on the one folder: the tool leaves scenes that would not change alone.
# A scene that went missing is made again.
SCENE_FILES := $(addprefix $(SCENE_FOLDER)/,$(SCENE_NAMES:%=%.glb) $(SKY_NAMES:%=%.hdr) failures)
$(SCENES): $(SCENE_TOOL) $(if $(filter-out $(wildcard $(SCENE_FILES)),$(SCENE_FILES)),FORCE)
	@mkdir -p $(SCENE_FOLDER)/failures
	$(SCENE_TOOL) $(SCENE_FOLDER)
	@touch $@

$(BUILD)/scenes/%.o: INCLUDES += -Iscenes

$(SCENE_TOOL): $(SCENE_TOOL_SOURCES:%.c=$(BUILD)/%.o) $(LIBRARY)
	$(say) LINK $@
	$(Q)$(CXX) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(LIBS)

# --- set-up ---------------------------------------------------------------------------------------

deps:
	@test/install-packages $(PACKAGES)

demo: deps
	@$(MAKE) --no-print-directory all
	./manylight render scenes/cornell-box.glb -o cornell-box.png -o cornell-box.exr --stats

clean:
	rm -rf build manylight $(PLUGIN_NAME) scenes/*.glb scenes/*.hdr scenes/failures

include mk/library.mk mk/install.mk mk/test.mk mk/python.mk mk/deb.mk

# --- benchmark ------------------------------------------------------------------------------------

BENCHES := validate outsiders bench chart accuracy methods fronts parsimony direct convergence stability table figures
.PHONY: $(BENCHES)
validate outsiders table: python
$(BENCHES): all
	@$(MAKE) --no-print-directory -f bench/Makefile $@ BUILD=$(BUILD) BINARY=$(BINARY) SCENE_NAMES="$(SCENE_NAMES)" PYTHON="$(PYTHON)"
