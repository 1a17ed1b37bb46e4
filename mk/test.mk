# Tests, sanitizers, fuzzers, coverage, mutants, static checks, and the bundle.

.PHONY: check test test-long tests asan tsan fuzz fuzzers test-all coverage mutants lint analyze bundle bundle-parts systems

# --- tests ----------------------------------------------------------------------------------------

TEST_SOURCES := $(sort $(shell find test -name 'test_*.c'))
TESTS_OF_VIEWER := $(filter-out %/test_output_file.c,$(shell grep -l '"view_[a-z]*.h"\|"desktop.h"\|"viewer/' $(TEST_SOURCES)))
TEST_PROGRAMS := $(patsubst %.c,$(BUILD)/test/%,$(notdir $(filter-out $(if $(VIEWER),,$(TESTS_OF_VIEWER)),$(TEST_SOURCES))))

# LONG=1: all rows of each test, not a few of each kind, and these programs: they fail calls one by one, or walk through the
# window by mouse and keys. `make test` has the two programs that compare the window's pictures.
LONG :=
LONG_TESTS := faults full_disk view view_arriving view_camera view_compiling view_idle view_keys view_leaks view_open \
    view_panel view_reference view_results view_start view_tools view_walk
TESTS := $(filter-out $(if $(LONG),,$(LONG_TESTS:%=$(BUILD)/test/test_%)),$(TEST_PROGRAMS))

# What test programs share.
TEST_SUPPORT := $(patsubst %.c,$(BUILD)/%.o,$(filter-out $(if $(VIEWER),,%/desktop.c %/view_stage.c),$(sort $(wildcard test/support/*.c))))
$(BUILD)/test/%.o: INCLUDES += -Itest/support
# All test programs share one library in the bundle.
TEST_LIBRARY := $(LIBRARY)

# Sources lie in a folder for each layer, all programs in one.
$(foreach source,$(TEST_SOURCES),$(eval $(BUILD)/test/$(basename $(notdir $(source))): $(source:%.c=$(BUILD)/%.o)))

$(TEST_PROGRAMS): $(TEST_SUPPORT) $(TEST_LIBRARY) | $(PLUGINS)
	$(say) LINK $@
	$(Q)$(CXX) $(CFLAGS) $(LDFLAGS) -o $@ $(filter %.o,$^) $(TEST_LIBRARY) $(LIBS) -lcmocka $(if $(VIEWER),-lX11)

# What is fed to the fuzzers and kept, read again.
FUZZ_OBJECTS := $(patsubst %.c,$(BUILD)/%.o,$(filter-out %/driver.c,$(sort $(wildcard test/fuzz/*.c))))
$(BUILD)/test/test_seeds: $(FUZZ_OBJECTS)
$(BUILD)/test/fuzz/%.o $(BUILD)/test/scene/test_seeds.o: INCLUDES += -Itest

# The sources of all programs, as drivers get them, for another compiler of GLSL to read.
SHADER_DUMP := $(BUILD)/test/shaders/dump
$(SHADER_DUMP): $(patsubst %.c,$(BUILD)/%.o,$(wildcard test/shaders/*.c)) $(LIBRARY)
	$(say) LINK $@
	$(Q)$(CXX) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(LIBS)

# The library is tested in the test programs, and as others get it.
$(BUILD)/test/test_library_installed: | $(SHARED) $(FINDERS)

# What makes calls of the program fail, for test_faults.
FAULTS := $(BUILD)/test/faults.so
$(BUILD)/test/test_faults: | $(FAULTS)

$(FAULTS): test/faults/faults.cpp
	@mkdir -p $(@D)
	$(say) CXX $@
	$(Q)$(CXX) -std=c++17 -O1 $(WARNINGS) -fPIC -shared -o $@ $<

# The program with one more technique and direct method, for tests. Each is a folder of test/guests, entered by a macro.
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

$(GUESTS)/manylight: $(MAIN_OBJECT) $(GUEST_OBJECTS) $(LIBRARY) | $(PLUGINS)
	$(say) LINK $@
	$(Q)$(CXX) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(LIBS)

$(BUILD)/test/test_guests: | $(GUESTS)/manylight

# The programs that find a fault of each layer within seconds, for `make check`. They are linked as one, which a link of
# each name starts: after an edit one program is linked and not all.
CHECKED := base file_colours json options output_file stored heat_map metrics compare islands blending animation \
    bvh_ray caster caster_pool clips darkness gltf gltf_refusals marching_cubes mended named_files packed \
    scene scene_parts scenes seeds shown solid lattice prefilter blur cluster passes \
    adaptive lookup gl gl_objects gl_pass shared brdf chain reference_rules seen \
    traced_specular vpl_sum reference panes ao vpl_tree manual about pages events pace frames
CHECKS := $(CHECKED:%=$(BUILD)/check/test_%)
$(foreach test,$(CHECKED),$(eval $(BUILD)/check/test_$(test).o: $(patsubst %.c,$(BUILD)/%.o,$(filter %/test_$(test).c,$(TEST_SOURCES)))))

$(CHECKS:%=%.o):
	@mkdir -p $(@D)
	@objcopy --redefine-sym main=$(basename $(@F)) $< $@

$(BUILD)/check/main.c: mk/test.mk
	@mkdir -p $(@D)
	@{ printf '#define _GNU_SOURCE\n#include <errno.h>\n#include <string.h>\n'; \
	   printf 'int test_%s(void);\n' $(CHECKED); echo 'int main(void) {'; \
	   for test in $(CHECKED); do \
	       echo "if (strcmp(program_invocation_short_name, \"test_$$test\") == 0) return test_$$test();"; done; \
	   echo 'return 2;}'; } > $@

$(BUILD)/check/main: $(BUILD)/check/main.c $(CHECKS:%=%.o) $(FUZZ_OBJECTS) $(TEST_SUPPORT) $(TEST_LIBRARY) | $(PLUGINS)
	$(say) LINK $@
	$(Q)$(CC) $(CFLAGS) -c -o $(@D)/main.o $<
	$(Q)$(CXX) $(CFLAGS) $(LDFLAGS) -o $@ $(@D)/main.o $(filter %.o,$^) $(TEST_LIBRARY) $(LIBS) -lcmocka $(if $(VIEWER),-lX11)

$(CHECKS): | $(BUILD)/check/main
	@ln -sf main $@

# LAYER=passes: all programs of test/passes, with the rows of `make tests`, in place of the fast ones.
check:
	$(if $(and $(LAYER),$(if $(wildcard test/$(LAYER)/test_*.c),,no)),$(error LAYER takes a folder of test/ with tests))
	@$(MAKE) --no-print-directory tests TESTS='$(if $(LAYER),$(patsubst %.c,$(BUILD)/test/%,$(notdir $(wildcard test/$(LAYER)/test_*.c))),$(CHECKS))'
	@test/lint quick

test: deps
	@$(MAKE) --no-print-directory tests

test-long: deps
	@$(MAKE) --no-print-directory tests LONG=1
	@test/leave-one-out $(BUILD) $(PARTS)

tests: $(BINARY) $(SCENES) $(TESTS)
	@MANYLIGHT_LONG=$(LONG) MANYLIGHT_BUILD=$(BUILD) MANYLIGHT_BINARY=$(if $(findstring /,$(BINARY)),,./)$(BINARY) test/run $(TESTS)

# --- bundle ---------------------------------------------------------------------------------------

# A folder, and an archive of it, that runs on a bare Linux machine with a driver of OpenGL: program, test programs, scenes
# and libraries, without the viewer (bundle/README). It is built apart, in BUNDLE_BUILD.
BUNDLE_PACKAGES := $(filter-out libopenimageio-dev libglfw3-dev libimgui-dev libx11-dev gnuplot-nox xvfb xauth xdotool,$(PACKAGES)) \
    patchelf
BUNDLE := build/bundle
BUNDLE_BUILD := build/bundle-parts

bundle:
	@test/install-packages $(BUNDLE_PACKAGES)
	@$(MAKE) --no-print-directory bundle-parts PICTURES=small WITHOUT=viewer VISIBILITY=default BUILD=$(BUNDLE_BUILD) \
	    BINARY=$(BUNDLE_BUILD)/manylight SCENE_FOLDER=$(BUNDLE_BUILD)/scenes/all \
	    TEST_LIBRARY=$(BUNDLE_BUILD)/libmanylight.so CFLAGS="$(CFLAGS) -fno-semantic-interposition"
	@bundle/pack $(BUNDLE_BUILD) $(BUNDLE)

bundle-parts: $(BINARY) $(SCENES) $(TEST_PROGRAMS) $(GUESTS)/manylight
	@printf '%s\n' $(TEST_PROGRAMS) > $(BUILD)/tests.list

$(BUILD)/libmanylight.so: $(LIBRARY)
	$(say) LINK $@
	$(Q)$(CXX) $(CFLAGS) $(LDFLAGS) -shared -Wl,-soname,$(@F) -o $@ -Wl,--whole-archive $< -Wl,--no-whole-archive $(LIBS)

# --- other builds ---------------------------------------------------------------------------------

# Tests of a build of its own kind, in its own folder.
tests_of = $(MAKE) --no-print-directory tests BUILD=build/$(1) BINARY=build/$(1)/manylight-$(1)

SANITIZE := -fsanitize=address,undefined -fno-omit-frame-pointer -fno-sanitize-recover=undefined
# Without the interception, whose list of threads' memory is wrong now and then, the search for leaks itself crashes.
asan: deps
	@+ASAN_OPTIONS=intercept_tls_get_addr=0 \
	    LSAN_OPTIONS=suppressions=$(CURDIR)/test/leaks-of-others:print_suppressions=0 \
	    $(call tests_of,asan) CFLAGS="-O1 -g $(SANITIZE)" LDFLAGS="$(SANITIZE)"

# What has threads of its own: the path tracer, the metrics, the loader, and the viewer, which loads, compiles, traces
# and measures in the background.
TSAN_TESTS := $(patsubst %,build/tsan/test/test_%,reference denoise sky metrics gltf view_compiling view_reference)
tsan: deps
	@+TSAN_OPTIONS="suppressions=$(CURDIR)/test/races-of-others exitcode=66" \
	    $(call tests_of,tsan) TESTS="$(TSAN_TESTS)" \
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

$(FUZZERS): $(BUILD)/fuzz_%: $(BUILD)/test/fuzz/driver_%.o $(FUZZ_OBJECTS) $(LIBRARY) | $(PLUGINS)
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
	@+$(foreach c,$(COMPILERS),$(call tests_of,$(c)) \
	    CC=$(word 1,$(subst -, ,$(c))) CXX=$(subst gcc,g++,$(subst clang,clang++,$(word 1,$(subst -, ,$(c))))) \
	    CFLAGS="-$(word 2,$(subst -, ,$(c))) -g $(if $(findstring clang,$(c)),-Wno-missing-field-initializers)" \
	    TESTS="$(SOME_TESTS:%=build/$(c)/test/test_%)" &&) true
	@$(MAKE) --no-print-directory lint analyze

# Other releases of Debian, each in a chroot below build/systems. Root is needed.
SYSTEMS := trixie sid
systems: all
	@test/systems $(SYSTEMS)

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
	@+$(call tests_of,coverage) \
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
	    $(wildcard src/passes/lights/cluster_*.vert src/passes/lights/cluster_*.comp src/passes/lights/val_distance.glsl)

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
