# manylight: make demo | test | test-all | asan | tsan | fuzz | coverage | mutants | lint | analyze | bench | chart | accuracy | methods | parsimony | direct | convergence | stability | bundle | deps | install | uninstall | clean
#
# A plain `make` only builds ./manylight. `make demo` and `make test` first install what is missing.

CC ?= cc
CXX ?= c++
PREFIX ?= /usr/local
BUILD ?= build
CFLAGS ?= -O2 -g
CXXFLAGS ?= $(CFLAGS)
WERROR ?= -Werror

# The binary of the default build lies at the top; other builds keep theirs in their folder.
BINARY ?= manylight

VERSION := 0.1
COMMIT := $(shell git describe --always --dirty 2>/dev/null || echo unknown)

# The commands are shown by make V=1.
Q := $(if $(V),,@)
say = @$(if $(V),:,printf '  %-4s %s\n')

# --- what it is made of ---------------------------------------------------------------------------

# Pictures go through OpenImageIO, or, by PICTURES=small, through libraries that know fewer formats and need few others.
# VIEWER= leaves the viewer's window out. `make bundle` sets both.
PICTURES ?= openimageio
VIEWER ?= yes
# Of the viewer's files, the one that tests of files and fuzzers use.
WITHOUT_WINDOW := src/viewer/scene/session.c
LEFT_OUT := $(if $(filter small,$(PICTURES)),src/base/file/image_%.cpp,src/base/file/small/%) \
    $(if $(VIEWER),,src/apps/view.c $(filter-out $(WITHOUT_WINDOW),$(shell find src/viewer -name '*.c*')))

# Floors are folders of src/, rooms folders of theirs, to any depth; src/main.c is no floor's. Shaders
# that belong to one technique or direct method lie in its folder, all others in glsl/.
SOURCES := $(filter-out $(LEFT_OUT),$(sort $(shell find src -mindepth 2 -name '*.c')))
BRIDGES := $(filter-out $(LEFT_OUT),$(sort $(shell find src -mindepth 2 -name '*.cpp')))
SHADERS := $(sort $(shell find glsl -type f -name '[!.]*') \
    $(shell find src -name '*.vert' -o -name '*.geom' -o -name '*.frag' -o -name '*.comp' -o -name '*.glsl'))
TESTS_OF_VIEWER := $(wildcard test/test_view*.c) \
    $(filter-out test/test_output_file.c,$(shell grep -l '"view_[a-z]*.h"\|"desktop.h"\|"viewer/' test/test_*.c))
TESTS := $(patsubst test/%.c,$(BUILD)/test/%,$(filter-out $(if $(VIEWER),,$(TESTS_OF_VIEWER)),$(sort $(wildcard test/test_*.c))))
SCENE_TOOL_SOURCES := $(sort $(shell find scenes -name '*.c'))
SCENE_TOOL := $(BUILD)/scenes/make_scenes
SCENE_NAMES := atrium cornell-box three-lights cornell-animal sphere metaballs moving-spot door creatures character table gloss materials roughness plant courtyard
SKY_NAMES := day overcast
SCENE_FOLDER := scenes
SCENES := $(BUILD)/scenes/made

# Debian's packages; OpenGL itself (libEGL, libOSMesa) is opened at run time.
PACKAGES := gcc g++ make pkg-config git libegl-dev libegl1 libgl-dev libgl1-mesa-dri libosmesa6 \
    libglfw3-dev libtinygltf-dev libstb-dev nlohmann-json3-dev libdraco-dev libmeshoptimizer-dev libopenimageio-dev libcglm-dev \
    libembree-dev libimgui-dev fonts-dejavu-core libcmocka-dev libx11-dev gnuplot-nox xvfb xdotool

PKG := cglm $(if $(filter small,$(PICTURES)),OpenEXR,OpenImageIO) $(if $(VIEWER),imgui glfw3)
INCLUDES := -Isrc -Iglsl -I$(BUILD)/include
WARNINGS := -Wall -Wextra $(WERROR)
C_FLAGS = -std=c11 -DCGLM_ALL_UNALIGNED $(WARNINGS) -Wstrict-prototypes -Wmissing-prototypes $(INCLUDES) $(PKG_CFLAGS) $(if $(VIEWER),,-DMANYLIGHT_NO_VIEWER) $(CFLAGS)
CXX_FLAGS = -std=c++17 $(WARNINGS) $(INCLUDES) $(PKG_CFLAGS) $(CXXFLAGS)
# System headers: their warnings are not ours.
PKG_CFLAGS := $(patsubst -I%,-isystem %,$(shell pkg-config --cflags $(PKG) 2>/dev/null))
PICTURE_LIBS := -lOpenEXRCore -lpng16 -ljpeg -lwebp
LIBS := $(if $(filter small,$(PICTURES)),$(PICTURE_LIBS),$(shell pkg-config --libs $(PKG) 2>/dev/null)) -lembree3 -ldraco -lmeshoptimizer -lstdc++ -ldl -lpthread -lm

EMBEDDED := $(BUILD)/glsl_embedded.o $(BUILD)/chart_embedded.o $(BUILD)/bounds_embedded.o
BOUNDS := $(sort $(wildcard src/techniques/*/bounds.csv))
OBJECTS := $(SOURCES:%.c=$(BUILD)/%.o) $(BRIDGES:%.cpp=$(BUILD)/%.o) $(EMBEDDED)
GUESTS := $(BUILD)/test/guests
MAIN_OBJECT := $(BUILD)/src/main.o
LIBRARY := $(BUILD)/libmanylight.a

.PHONY: all demo test test-all tests asan tsan fuzz fuzzers coverage mutants lint analyze bench chart accuracy methods fronts parsimony direct convergence stability bundle bundle-parts deps install uninstall clean FORCE
.DELETE_ON_ERROR:
.SECONDARY:

all: $(BINARY) $(SCENES)

$(BINARY): $(MAIN_OBJECT) $(LIBRARY)
	$(say) LINK $@
	$(Q)$(CXX) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(LIBS)

$(LIBRARY): $(OBJECTS)
	@rm -f $@
	$(say) AR $@
	$(Q)ar rcs $@ $^

$(BUILD)/%.o: %.c | $(BUILD)/include/version.h $(BUILD)/include/sources.h
	@mkdir -p $(@D)
	$(say) CC $@
	$(Q)$(CC) $(C_FLAGS) -MMD -MP -c -o $@ $<

$(BUILD)/%.o: %.cpp
	@mkdir -p $(@D)
	$(say) CXX $@
	$(Q)$(CXX) $(CXX_FLAGS) -MMD -MP -c -o $@ $<

# Rewritten only when they say something new, so that a build without changes does nothing. What
# cached pictures depend on: the sources of the path tracer, and all that the renderer is made of.
sum = $$(find $(1) -type f | LC_ALL=C sort | xargs cat | cksum | tr ' ' -)
keep = @cmp -s $@ $@.new && rm $@.new || mv $@.new $@

$(BUILD)/include/version.h: FORCE
	@mkdir -p $(@D)
	@printf '#define MANYLIGHT_VERSION "%s"\n#define MANYLIGHT_COMMIT "%s"\n' \
	    $(VERSION) $(COMMIT) > $@.new
	$(keep)

$(BUILD)/include/sources.h: FORCE
	@mkdir -p $(@D)
	@printf '#define MANYLIGHT_TRACER "%s"\n#define MANYLIGHT_SOURCES "%s"\n' \
	    "$(call sum,src/reference src/scene)" "$(call sum,src glsl)" > $@.new
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

$(BUILD)/chart_embedded.c: bench/chart.gp Makefile
	@mkdir -p $(@D)
	@{ echo 'extern const char chart_script[];'; echo 'const char chart_script[] ='; \
	   $(quote) $<; echo ';'; } > $@

# The rows of all techniques, each behind the technique's name.
$(BUILD)/bounds_embedded.c: $(BOUNDS) Makefile
	@mkdir -p $(@D)
	@{ echo 'extern const char failure_bounds[];'; echo 'const char failure_bounds[] ='; \
	   awk '{ sub(".*techniques/", "", FILENAME); sub("/.*", "", FILENAME); print FILENAME "," $$0 }' $(BOUNDS) | \
	   $(quote); echo ';'; } > $@

$(BUILD)/%_embedded.o: $(BUILD)/%_embedded.c
	$(say) CC $@
	$(Q)$(CC) $(C_FLAGS) -c -o $@ $<

-include $(shell find $(BUILD) -name '*.d' 2>/dev/null)

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

# --- tests ----------------------------------------------------------------------------------------

# What test programs share: the files of test/ that are no programs.
TEST_SUPPORT := $(patsubst %.c,$(BUILD)/%.o,$(filter-out test/test_%.c $(if $(VIEWER),,test/desktop.c $(wildcard test/view_*.c)),$(sort $(wildcard test/*.c))))
# A hundred programs share one library in the bundle.
TEST_LIBRARY := $(LIBRARY)

$(BUILD)/test/%: $(BUILD)/test/%.o $(TEST_SUPPORT) $(TEST_LIBRARY)
	$(say) LINK $@
	$(Q)$(CXX) $(CFLAGS) $(LDFLAGS) -o $@ $(filter %.o,$^) $(TEST_LIBRARY) $(LIBS) -lcmocka $(if $(VIEWER),-lX11)

# What is fed to the fuzzers and kept, read again.
FUZZ_OBJECTS := $(patsubst %.c,$(BUILD)/%.o,$(filter-out %/driver.c,$(sort $(wildcard test/fuzz/*.c))))
$(BUILD)/test/test_seeds: $(FUZZ_OBJECTS)
$(BUILD)/test/fuzz/%.o $(BUILD)/test/test_seeds.o: INCLUDES += -Itest

# The sources of all programs, as drivers get them, for another compiler of GLSL to read.
SHADER_DUMP := $(BUILD)/test/shaders/dump
$(SHADER_DUMP): $(patsubst %.c,$(BUILD)/%.o,$(wildcard test/shaders/*.c)) $(LIBRARY)
	$(say) LINK $@
	$(Q)$(CXX) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(LIBS)

# What makes calls of the program fail, for test_faults.
FAULTS := $(BUILD)/test/faults.so
$(BUILD)/test/test_faults: | $(FAULTS)

$(FAULTS): test/faults/faults.cpp
	@mkdir -p $(@D)
	$(say) CXX $@
	$(Q)$(CXX) -std=c++17 -O1 $(WARNINGS) -fPIC -shared -o $@ $<

# The program with a technique and a direct method more, which only tests have: what a newcomer to the
# house adds is a folder and a line of a registry, here told by a macro.
GUEST_SOURCES := $(sort $(shell find test/guests -name '*.c'))
GUEST_SHADERS := $(sort $(shell find test/guests -name '*.frag' -o -name '*.comp'))
GUEST_OBJECTS := $(GUEST_SOURCES:%.c=$(BUILD)/%.o) $(GUESTS)/techniques.o $(GUESTS)/direct.o \
    $(GUESTS)/glsl_embedded.o

$(GUESTS)/glsl_embedded.c: $(SHADERS) $(GUEST_SHADERS)

$(GUESTS)/%.o: src/%/registry.c
	@mkdir -p $(@D)
	$(say) CC $@
	$(Q)$(CC) $(C_FLAGS) '-DMORE_TECHNIQUES(X)=X(ambient)' '-DMORE_METHODS(X)=X(headlamp)' \
	    -MMD -MP -c -o $@ $<

$(GUESTS)/manylight: $(MAIN_OBJECT) $(GUEST_OBJECTS) $(LIBRARY)
	$(say) LINK $@
	$(Q)$(CXX) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(LIBS)

tests: $(BINARY) $(SCENES) $(TESTS) $(GUESTS)/manylight
	@MANYLIGHT_BUILD=$(BUILD) MANYLIGHT_BINARY=$(if $(findstring /,$(BINARY)),,./)$(BINARY) test/run $(TESTS)

# --- benchmark --------------------------------------------------------------------------------------

# The paper's scenes, and what stands in ../shared where there is one.
OWN_SCENES := $(addprefix scenes/,cornell-box.glb cornell-animal.glb atrium.glb metaballs.glb)
BENCH_SCENES := $(OWN_SCENES) $(wildcard ../shared/scenes/*.glb)
# Figures to keep: make bench BENCH_RESULTS=bench/results BENCH_PLOTS=bench/plots
BENCH_RESULTS := $(BUILD)/bench
BENCH_PLOTS := $(BENCH_RESULTS)/plots
REFERENCE_CACHE := $(BUILD)/reference-cache

# Large scenes take many more paths for the same noise; the two Sponzas are one view.
LARGE_SCENES := $(filter %/atrium.glb %/sponza-98k.glb,$(BENCH_SCENES))
SMALL_SCENES := $(filter-out $(LARGE_SCENES) %/sponza.glb,$(BENCH_SCENES))
NOISE_OF_SMALL := --noise .02
NOISE_OF_LARGE := --noise .06

# Speed against accuracy: a grid of the method, the denoised tracer, and what else it competes with. Of the two Cornell boxes
# ours. Large scenes take seconds a frame, and a map per VPL takes most: fewer rounds do.
CHART_RUN = sweep --reference path --cache $(REFERENCE_CACHE) --size 400x400
CHART_SMALL := $(filter-out ../%/cornell-box.glb,$(SMALL_SCENES)) $(NOISE_OF_SMALL) --frames 3
CHART_LARGE := $(LARGE_SCENES) $(NOISE_OF_LARGE)
CHART_GRID := --variant paper --variant fast --vary M=2,8,30,120 --tracer
CHART_RIVALS := --variant unshadowed --variant instant-radiosity
SWEEP := $(BENCH_RESULTS)/sweep.csv

bench: all
	@mkdir -p $(BENCH_RESULTS)
	$(call BENCH_ROWS,$(BENCH_RESULTS)/times.csv,times $(BENCH_SCENES) $(BENCH_OPTIONS))
	$(call DONE_ROWS,$(BENCH_RESULTS)/times.csv)

# Runs bench with --csv FILE: FILE, arguments. A driver that was broken off leaves out the runs that were done, by the same
# program and command, and goes on within the others (bench's FILE.part).
BENCH_ROWS = @if [ $(1) -nt $(BINARY) ] && [ "$$(cat $(1).command 2>/dev/null)" = '$(strip $(2))' ]; then \
    echo '$(1) is there'; \
    else set -x; ./manylight bench $(2) --csv $(1) && echo '$(strip $(2))' > $(1).command; fi

# The driver is done: it measures anew the next time.
DONE_ROWS = @rm -f $(addsuffix .command,$(1))

# FILE: made of all runs' rows, FILE.1 and so on, with one heading.
JOIN_ROWS = @awk 'FNR > 1 || NR == 1' $(1).[1-9] > $(1) && rm $(1).[1-9] $(1).[1-9].command

# Measured anew each time, but for what a driver that was broken off has.
chart: all
	@mkdir -p $(BENCH_RESULTS)
	$(call BENCH_ROWS,$(SWEEP).1,$(CHART_RUN) $(CHART_SMALL) $(CHART_GRID) $(BENCH_OPTIONS))
	$(call BENCH_ROWS,$(SWEEP).2,$(CHART_RUN) $(CHART_SMALL) $(CHART_RIVALS) $(BENCH_OPTIONS))
	$(call BENCH_ROWS,$(SWEEP).3,$(CHART_RUN) $(CHART_LARGE) --frames 2 $(CHART_GRID) $(BENCH_OPTIONS))
	$(call BENCH_ROWS,$(SWEEP).4,$(CHART_RUN) $(CHART_LARGE) --frames 1 $(CHART_RIVALS) $(BENCH_OPTIONS))
	$(call JOIN_ROWS,$(SWEEP))
	./manylight bench chart $(SWEEP) -o $(BENCH_PLOTS)

# Where the error of a frame comes from, and how it falls with M, K, N and the size of maps.
BUDGET_SIZE := 400x400
BUDGET_RUN = budget --tracer --size $(BUDGET_SIZE) --cache $(REFERENCE_CACHE)
CURVES_SIZE := 200x200

accuracy: all
	@mkdir -p $(BENCH_RESULTS)
	$(call BENCH_ROWS,$(BENCH_RESULTS)/budget.csv,$(BUDGET_RUN) $(SMALL_SCENES) $(NOISE_OF_SMALL))
	$(call BENCH_ROWS,$(BENCH_RESULTS)/budget-large.csv,$(BUDGET_RUN) $(LARGE_SCENES) $(NOISE_OF_LARGE))
	$(call BENCH_ROWS,$(BENCH_RESULTS)/curves.csv,curves $(filter-out %/atrium.glb,$(OWN_SCENES)) --size $(CURVES_SIZE) \
	    $(NOISE_OF_SMALL) --cache $(REFERENCE_CACHE))
	$(call DONE_ROWS,$(addprefix $(BENCH_RESULTS)/,budget.csv budget-large.csv curves.csv))
	./manylight bench chart $(BENCH_RESULTS)/curves.csv -o $(BENCH_PLOTS)

# All techniques, error against time. Those of one count of VPLs take turns: a run each. The public rooms are matt and lit
# by their spot. Brute force is dear: rows and columns of 1024 VPLs alone, a map for each of 1024 in boxes alone.
METHODS := $(addprefix --variant ,high clustered traced visibility=traced:technique=clustered,clustered.visibility=traced \
    cluster-lights lightcuts imperfect-shadow-maps unshadowed)
METHODS_OF_256 := --vary N=256 --variant instant-radiosity --tracer
METHODS_OF_1024 := --vary N=1024 --variant row-column
METHODS_RUN = sweep --reference path --cache $(REFERENCE_CACHE) --size 200x200 --frames 1 $(METHODS)
METHODS_SMALL := $(SMALL_SCENES) --noise .01
METHODS_LARGE := $(LARGE_SCENES) $(wildcard ../shared/scenes/sponza.glb) --noise .05
METHODS_ROOMS := $(wildcard ../shared/scenes/public/*.glb)
METHODS_ROOMS += $(if $(METHODS_ROOMS),--noise .05 --light spot --set materials=diffuse)
METHODS_ROWS := $(BENCH_RESULTS)/methods.csv

methods: all
	@mkdir -p $(BENCH_RESULTS)
	$(call BENCH_ROWS,$(METHODS_ROWS).1,$(METHODS_RUN) $(METHODS_SMALL) $(METHODS_OF_256))
	$(call BENCH_ROWS,$(METHODS_ROWS).2,$(METHODS_RUN) $(METHODS_SMALL) $(METHODS_OF_1024) --variant instant-radiosity)
	$(call BENCH_ROWS,$(METHODS_ROWS).3,$(METHODS_RUN) $(METHODS_LARGE) $(METHODS_OF_256))
	$(call BENCH_ROWS,$(METHODS_ROWS).4,$(METHODS_RUN) $(METHODS_LARGE) $(METHODS_OF_1024))
	$(if $(strip $(METHODS_ROOMS)),$(call BENCH_ROWS,$(METHODS_ROWS).5,$(METHODS_RUN) $(METHODS_ROOMS) $(METHODS_OF_256)))
	$(if $(strip $(METHODS_ROOMS)),$(call BENCH_ROWS,$(METHODS_ROWS).6,$(METHODS_RUN) $(METHODS_ROOMS) $(METHODS_OF_1024)))
	$(call JOIN_ROWS,$(METHODS_ROWS))
	./manylight bench chart $(METHODS_ROWS) -o $(BENCH_PLOTS)/methods

# The two frames of clustered, by maps and by rays, with few and many VPLs, and with and without adaptive pixels; then the
# default without one of its parts at a time, beside the denoised tracer.
FRONTS_GRID := --vary N=128,256,512,1024 --variant maps:technique=clustered,path=fast --variant rays:technique=clustered,path=traced \
    --variant maps-even:technique=clustered,gather.adaptive=0 --variant rays-even:technique=clustered,path=traced,gather.adaptive=0
FRONTS_WITHOUT := --vary N=1024 $(addprefix --variant ,maps:technique=clustered,path=fast \
    no-correction:technique=clustered,clustered.ray-tests=0 no-arcs:technique=clustered,caster.long=0 \
    no-edge-samples:technique=clustered,gather.edge-samples=off no-blocks:technique=clustered,clustered.visibility-block=0 \
    cluster-lights) --tracer
FRONTS_SMALL := $(CHART_SMALL) --frames 5
FRONTS_LARGE := $(CHART_LARGE) --frames 2
FRONTS_ROOMS := $(METHODS_ROOMS) $(if $(strip $(METHODS_ROOMS)),--frames 2)
FRONTS_ROWS := $(BENCH_RESULTS)/fronts.csv

fronts: all
	@mkdir -p $(BENCH_RESULTS)
	$(call BENCH_ROWS,$(FRONTS_ROWS).1,$(CHART_RUN) $(FRONTS_SMALL) $(FRONTS_GRID))
	$(call BENCH_ROWS,$(FRONTS_ROWS).2,$(CHART_RUN) $(FRONTS_SMALL) $(FRONTS_WITHOUT))
	$(call BENCH_ROWS,$(FRONTS_ROWS).3,$(CHART_RUN) $(FRONTS_LARGE) $(FRONTS_GRID))
	$(call BENCH_ROWS,$(FRONTS_ROWS).4,$(CHART_RUN) $(FRONTS_LARGE) $(FRONTS_WITHOUT))
	$(if $(strip $(FRONTS_ROOMS)),$(call BENCH_ROWS,$(FRONTS_ROWS).5,$(CHART_RUN) $(FRONTS_ROOMS) $(FRONTS_GRID)))
	$(if $(strip $(FRONTS_ROOMS)),$(call BENCH_ROWS,$(FRONTS_ROWS).6,$(CHART_RUN) $(FRONTS_ROOMS) $(FRONTS_WITHOUT)))
	$(call JOIN_ROWS,$(FRONTS_ROWS))
	./manylight bench chart $(FRONTS_ROWS) -o $(BENCH_PLOTS)/fronts

# What --max-error chooses against fixed settings, and what it tells of them and of closer views: a file a scene, and those that are
# there and of this program are left, so that it goes on where it was broken off. Then all rows, charts, what was chosen, and ladders that know
# nothing of a scene. Half an hour of CPU time, most of it in halls and rooms. Sheets of materials are left out: truths of what shines
# are dear.
PARSIMONY := $(BENCH_RESULTS)/parsimony
PARSIMONY_FAILURES := room table-legs contact thin-wall corner val-plane center-inside closed-door grazing-light \
    grazing-receivers wide-light ball-lamp needle empty-map black white plain giant-triangle tiny-triangles millimetre \
    kilometre far-away
PARSIMONY_SCENES := $(patsubst %,scenes/%.glb,$(filter-out gloss materials roughness,$(SCENE_NAMES))) $(PARSIMONY_FAILURES:%=scenes/failures/%.glb) \
    $(wildcard ../shared/scenes/*.glb ../shared/scenes/public/*.glb)
PARSIMONY_CLOSER := cornell-box cornell-animal metaballs
PARSIMONY_FILES = $(patsubst %.glb,$(PARSIMONY)/%.csv,$(PARSIMONY_SCENES:../%=%)) $(PARSIMONY_CLOSER:%=$(PARSIMONY)/closer/%.csv)
PARSIMONY_ROWS := $(BENCH_RESULTS)/quality.csv

$(PARSIMONY)/%.csv: PARSIMONY_OPTIONS := --size 96x96 --noise .02 --passes 16
$(addprefix $(PARSIMONY)/,$(addprefix scenes/,atrium.csv creatures.csv character.csv courtyard.csv) \
    shared/scenes/sponza.csv shared/scenes/sponza-98k.csv): \
    PARSIMONY_OPTIONS := --size 120x120 --noise .06 --passes 4
$(PARSIMONY)/shared/scenes/public/%.csv: \
    PARSIMONY_OPTIONS := --size 120x120 --noise .06 --passes 4 --light spot --set materials=diffuse
$(PARSIMONY)/closer/%.csv: PARSIMONY_OPTIONS := --size 200x200 --noise .03 --passes 1 --told --camera "0 fov=.4"

PARSIMONY_RUN = @mkdir -p $(@D); set -x; ./manylight bench quality $(1) $(PARSIMONY_OPTIONS) --cache $(REFERENCE_CACHE) --csv $@

$(PARSIMONY)/scenes/%.csv: $(BINARY) | all
	$(call PARSIMONY_RUN,scenes/$*.glb)
$(PARSIMONY)/shared/%.csv: $(BINARY) | all
	$(call PARSIMONY_RUN,../shared/$*.glb)
$(PARSIMONY)/closer/%.csv: $(BINARY) | all
	$(call PARSIMONY_RUN,scenes/$*.glb)

# Two boxes have one name: their faces tell them apart.
parsimony: $(PARSIMONY_FILES)
	@mkdir -p $(BENCH_PLOTS)
	@awk -F, -v OFS=, 'FNR == 1 && NR > 1 { next } FILENAME ~ "shared/scenes/cornell-box" { $$2 = $$2 "-" $$3 } 1' $^ \
	    > $(PARSIMONY_ROWS)
	gnuplot -e "csv='$(PARSIMONY_ROWS)'; folder='$(BENCH_PLOTS)'" bench/parsimony.gp
	@awk -f bench/chosen.awk $(PARSIMONY_ROWS)
	@awk -f bench/leave-one-out.awk $(PARSIMONY_ROWS)

# What is seen of lamps, by each method of direct light, and the tables of soft shadows.
direct: all
	@mkdir -p $(BENCH_RESULTS)
	$(call BENCH_ROWS,$(BENCH_RESULTS)/direct.csv,direct --cache $(REFERENCE_CACHE) $(BENCH_OPTIONS))
	$(call BENCH_ROWS,$(BENCH_RESULTS)/direct-tables.csv,direct scenes/table.glb --size 400x400 --cache $(REFERENCE_CACHE) \
	    --tables --variant vssm:direct=vssm)
	$(call DONE_ROWS,$(addprefix $(BENCH_RESULTS)/,direct.csv direct-tables.csv))
	./manylight bench chart $(BENCH_RESULTS)/direct.csv -o $(BENCH_PLOTS)

# How the mean of passes converges: minutes of the boxes, a quarter of an hour of CPU time for each large scene.
CONVERGENCE_RUN = passes --size 200x200 --cache $(REFERENCE_CACHE) $(BENCH_OPTIONS)

convergence: all
	@mkdir -p $(BENCH_RESULTS)
	$(call BENCH_ROWS,$(BENCH_RESULTS)/passes.csv,$(CONVERGENCE_RUN) scenes/cornell-box.glb scenes/metaballs.glb --noise .005)
	$(call BENCH_ROWS,$(BENCH_RESULTS)/passes-large.csv,$(CONVERGENCE_RUN) $(LARGE_SCENES) --noise .03)
	$(call DONE_ROWS,$(addprefix $(BENCH_RESULTS)/,passes.csv passes-large.csv))
	./manylight bench chart $(BENCH_RESULTS)/passes.csv $(BENCH_RESULTS)/passes-large.csv -o $(BENCH_PLOTS)

# --- stability ------------------------------------------------------------------------------------

# Flicker and VALs in use over the clips of the moving scenes, the largest with fewer lights; against
# the truth on short clips; then the cases where methods break, each with a picture.
MOVING_SCENES := $(patsubst %,scenes/%.glb,moving-spot metaballs door)
STABILITY_OPTIONS := --size 160x120 --frames 20
CREATURES_OPTIONS := --size 160x120 --frames 6 --set vpls=256 --set map-size=64
TRUTH_OPTIONS := --size 80x60 --frames 8 --reference path --noise .03
FAILURES_OPTIONS := --size 160x120 --noise .02
THREE_VARIANTS := --variant instant-radiosity --variant paper --variant fast

stability: all
	@mkdir -p $(BENCH_RESULTS)
	$(call BENCH_ROWS,$(BENCH_RESULTS)/temporal.csv,temporal $(MOVING_SCENES) $(STABILITY_OPTIONS))
	./manylight bench chart $(BENCH_RESULTS)/temporal.csv -o $(BENCH_PLOTS)
	$(call BENCH_ROWS,$(BENCH_RESULTS)/temporal-creatures.csv,temporal scenes/creatures.glb $(CREATURES_OPTIONS) \
	    $(THREE_VARIANTS))
	$(call BENCH_ROWS,$(BENCH_RESULTS)/temporal-truth.csv,temporal $(MOVING_SCENES) $(TRUTH_OPTIONS) $(THREE_VARIANTS))
	$(call BENCH_ROWS,$(BENCH_RESULTS)/failures.csv,failures --cache $(REFERENCE_CACHE) -o $(BENCH_RESULTS)/failures \
	    $(FAILURES_OPTIONS))
	$(call DONE_ROWS,$(addprefix $(BENCH_RESULTS)/,temporal.csv temporal-creatures.csv temporal-truth.csv failures.csv))

# --- bundle ---------------------------------------------------------------------------------------

# A folder, and an archive of it, that runs on a bare Linux machine with a driver of OpenGL: program, test programs, scenes
# and libraries, without the viewer (bundle/README). It is built apart, in BUNDLE_BUILD.
BUNDLE_PACKAGES := $(filter-out libopenimageio-dev libglfw3-dev libimgui-dev libx11-dev gnuplot-nox xvfb xdotool,$(PACKAGES)) \
    libopenexr-dev libpng-dev libjpeg-dev libwebp-dev patchelf
BUNDLE := build/bundle
BUNDLE_BUILD := build/bundle-parts

bundle:
	@test/install-packages $(BUNDLE_PACKAGES)
	@$(MAKE) --no-print-directory bundle-parts PICTURES=small VIEWER= BUILD=$(BUNDLE_BUILD) \
	    BINARY=$(BUNDLE_BUILD)/manylight SCENE_FOLDER=$(BUNDLE_BUILD)/scenes/all \
	    TEST_LIBRARY=$(BUNDLE_BUILD)/libmanylight.so CFLAGS="$(CFLAGS) -fPIC -fno-semantic-interposition"
	@bundle/pack $(BUNDLE_BUILD) $(BUNDLE)

bundle-parts: $(BINARY) $(SCENES) $(TESTS) $(GUESTS)/manylight
	@printf '%s\n' $(TESTS) > $(BUILD)/tests.list

$(BUILD)/libmanylight.so: $(LIBRARY)
	$(say) LINK $@
	$(Q)$(CXX) $(CFLAGS) $(LDFLAGS) -shared -Wl,-soname,$(@F) -o $@ -Wl,--whole-archive $< -Wl,--no-whole-archive $(LIBS)

# --- set-up ---------------------------------------------------------------------------------------

deps:
	@test/install-packages $(PACKAGES)

demo: deps
	@$(MAKE) --no-print-directory all
	./manylight render scenes/cornell-box.glb -o cornell-box.png -o cornell-box.exr --stats

test: deps
	@$(MAKE) --no-print-directory tests

SANITIZE := -fsanitize=address,undefined -fno-omit-frame-pointer -fno-sanitize-recover=undefined
# Without the interception, whose list of threads' memory is wrong now and then, the search for leaks itself crashes.
asan: deps
	@ASAN_OPTIONS=intercept_tls_get_addr=0 \
	    LSAN_OPTIONS=suppressions=$(CURDIR)/test/leaks-of-others:print_suppressions=0 \
	    $(MAKE) --no-print-directory tests BUILD=build/asan BINARY=build/asan/manylight-asan \
	    CFLAGS="-O1 -g $(SANITIZE)" LDFLAGS="$(SANITIZE)"

# What has threads of its own: the path tracer, the metrics, the loader, and the viewer, which loads, compiles, traces
# and measures in the background.
TSAN_TESTS := $(patsubst %,build/tsan/test/test_%,reference denoise sky metrics gltf view_compiling view_reference)
tsan: deps
	@TSAN_OPTIONS="suppressions=$(CURDIR)/test/races-of-others exitcode=66" \
	    $(MAKE) --no-print-directory tests BUILD=build/tsan BINARY=build/tsan/manylight-tsan TESTS="$(TSAN_TESTS)" \
	    CFLAGS="-O1 -g -fsanitize=thread" LDFLAGS="-fsanitize=thread"

# Made-up files and texts for so many seconds each, with clang's libFuzzer; what it finds is left in
# build/fuzz.
SECONDS := 60
FUZZ := scene picture text
FUZZERS := $(FUZZ:%=$(BUILD)/fuzz_%)
FUZZ_FLAGS := -O1 -g $(SANITIZE) -fsanitize=fuzzer-no-link -Wno-missing-field-initializers

fuzz: deps
	@test/install-packages clang
	@$(MAKE) --no-print-directory fuzzers BUILD=build/fuzz CC=clang CXX=clang++ \
	    CFLAGS="$(FUZZ_FLAGS)" LDFLAGS="$(SANITIZE)"

fuzzers: $(FUZZERS)
	@$(foreach name,$(FUZZ),test/fuzz/run $(BUILD)/fuzz_$(name) test/fuzz/seeds/$(name) $(SECONDS) &&) true

$(FUZZERS): $(BUILD)/fuzz_%: $(BUILD)/test/fuzz/driver_%.o $(FUZZ_OBJECTS) $(LIBRARY)
	$(say) LINK $@
	$(Q)$(CXX) $(CFLAGS) $(LDFLAGS) -fsanitize=fuzzer -o $@ $^ $(LIBS)

$(FUZZ:%=$(BUILD)/test/fuzz/driver_%.o): $(BUILD)/test/fuzz/driver_%.o: test/fuzz/driver.c
	@mkdir -p $(@D)
	$(say) CC $@
	$(Q)$(CC) $(C_FLAGS) -DFUZZ=fuzz_$* -MMD -MP -c -o $@ $<

# Everything built by two compilers without and with optimisation, with a few tests of each floor; then what
# reads the code alone.
COMPILERS := gcc-O0 gcc-O3 clang-O0 clang-O3
SOME_TESTS := base exr scene gltf metrics emitters compare passes render

test-all: deps
	@test/install-packages clang
	@$(foreach c,$(COMPILERS),$(MAKE) --no-print-directory tests BUILD=build/$(c) BINARY=build/$(c)/manylight-$(c) \
	    CC=$(word 1,$(subst -, ,$(c))) CXX=$(subst gcc,g++,$(subst clang,clang++,$(word 1,$(subst -, ,$(c))))) \
	    CFLAGS="-$(word 2,$(subst -, ,$(c))) -g $(if $(findstring clang,$(c)),-Wno-missing-field-initializers)" \
	    TESTS="$(SOME_TESTS:%=build/$(c)/test/test_%)" &&) true
	@$(MAKE) --no-print-directory lint analyze

# How much of the lower floors their tests reach, and the programs that those start, as gcovr tells it; of branches
# without those that exceptions take. C++ is compiled with -O1: without it GCC gives the destructors of temporaries
# in a short circuit branches of their own, a quarter of all. Without test_full_disk, whose limits cut gcov's files too.
COVERED := base scene lights metrics
COVERING := base options exr gltf gltf_refusals packed scene scene_parts animation framing metrics heat_map compare output_file info emissive emitters \
    environment environment_fit memory seeds light starts robust failures reference_app several_lights bench sky \
    marching_cubes caster caster_pool sequence hostile reference imperfect area_lights faults machine
COVERAGE := --coverage -fprofile-update=atomic

coverage: deps
	@test/install-packages gcovr
	@find build/coverage -name '*.gcda' -delete 2>/dev/null || true
	@$(MAKE) --no-print-directory tests BUILD=build/coverage BINARY=build/coverage/manylight-coverage \
	    CFLAGS="-O0 -g $(COVERAGE)" CXXFLAGS="-O1 -g $(COVERAGE)" LDFLAGS="$(COVERAGE)" TESTS="$(COVERING:%=build/coverage/test/test_%)"
	@for what in "" --branches; do gcovr -r . --object-directory build/coverage $(COVERED:%=--filter src/%/) \
	    --exclude src/scene/gpu/ --exclude-throw-branches --exclude-unreachable-branches \
	    --exclude-lines-by-pattern '.*assert\(.*' $$what; done

# How many small faults in the code the tests notice: so many, of all that test/mutate can make; SEED=2 ... picks others.
MUTANTS := 50
mutants: all $(patsubst %,$(BUILD)/test/test_%,metrics heat_map options cluster passes cluster_lights)
	@test/mutate $(BUILD) $(MUTANTS) "test_metrics test_heat_map" src/metrics/*.c src/metrics/flip/*.c
	@test/mutate $(BUILD) $(MUTANTS) test_options src/base/option.c src/base/settings.c
	@test/mutate $(BUILD) $(MUTANTS) "test_cluster test_passes test_cluster_lights" src/passes/lights/cluster.c \
	    $(wildcard glsl/lights/cluster_* glsl/lights/val_distance.glsl glsl/lights/val_seed.glsl)

lint: $(BUILD)/shaders.checked
	@test/install-packages clang-format
	@test/lint

$(BUILD)/shaders.checked: $(SHADER_DUMP) $(SHADERS) test/shaders/check | $(SCENES)
	@test/install-packages glslang-tools
	$(say) LINT shaders
	$(Q)test/shaders/check $(SHADER_DUMP) $(SHADERS)
	@touch $@

analyze: all
	@test/install-packages cppcheck clang-tidy
	@test/analyze

# Below PREFIX lies a list of what was installed, also by versions before: uninstall removes these files, the list, and
# folders of the program that are empty then.
SHARE := share/manylight
DOC := share/doc/manylight
INSTALLED := $(SHARE)/installed

install: all
	@echo "  INST $(DESTDIR)$(PREFIX)"
	@set -e; root="$(DESTDIR)$(PREFIX)"; install -d "$$root/$(SHARE)"; \
	put() { folder=$$1; mode=$$2; shift 2; for file; do \
	    install -D -m $$mode "$$file" "$$root/$$folder/$${file##*/}"; \
	    echo "$$folder/$${file##*/}" >> "$$root/$(INSTALLED)"; done; }; \
	put bin 755 manylight; \
	put $(DOC) 644 LICENSE; \
	put $(SHARE)/scenes 644 scenes/*.glb scenes/*.hdr; \
	put $(SHARE)/scenes/failures 644 scenes/failures/*.glb; \
	sort -u -o "$$root/$(INSTALLED)" "$$root/$(INSTALLED)"

uninstall:
	@echo "  RM   $(DESTDIR)$(PREFIX)"
	@cd "$(DESTDIR)$(PREFIX)" && test -f $(INSTALLED) || { echo "nothing to uninstall: $(INSTALLED) is not there"; exit 1; }
	@set -e; cd "$(DESTDIR)$(PREFIX)"; while read -r file; do rm -f "$$file"; done < $(INSTALLED); rm $(INSTALLED); \
	for folder in $(SHARE) $(DOC); do test ! -d $$folder || find $$folder -depth -type d -empty -delete; done

clean:
	rm -rf build manylight scenes/*.glb scenes/*.hdr scenes/failures
