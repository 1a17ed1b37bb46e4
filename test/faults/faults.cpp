/* Makes one call of the program fail, to see what becomes of it (LD_PRELOAD).
 *
 * Calls that can fail and that the program's own code makes are told apart by where it makes them:
 * by the innermost returns into its code. FAULT=N lets the first call from the N-th such place fail
 * as it would by itself; FAULT=0 none. FAULT_LOG names a file for "N FUNCTION" of each place, or
 * only of the one that failed. What libraries call by themselves is let alone, and what comes
 * before main and after it. */
#ifndef _GNU_SOURCE
#define _GNU_SOURCE
#endif
#include <cerrno>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

#include <EGL/egl.h>
#include <GL/glcorearb.h>
#include <dlfcn.h>
#include <execinfo.h>
#include <fcntl.h>
#include <link.h>
#include <pthread.h>
#include <semaphore.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace {

enum { DEPTH = 6, PLACES_MAX = 1 << 13, FRAMES_MAX = 24 };

struct range {
    uintptr_t begin, end;
};

/* The program comes first in the list of what is loaded. */
int find_program(struct dl_phdr_info *info, size_t, void *to) {
    range *code = static_cast<range *>(to);
    for (int i = 0; i < info->dlpi_phnum; i++)
        if (info->dlpi_phdr[i].p_type == PT_LOAD && info->dlpi_phdr[i].p_flags & PF_X) {
            code->begin = info->dlpi_addr + info->dlpi_phdr[i].p_vaddr;
            code->end = code->begin + info->dlpi_phdr[i].p_memsz;
        }
    return 1;
}

bool in_program(const void *address) {
    static range code;
    if (!code.end)
        dl_iterate_phdr(find_program, &code);
    uintptr_t at = reinterpret_cast<uintptr_t>(address);
    return at >= code.begin && at < code.end;
}

/* One place at a time, whichever thread comes first. */
pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
uint64_t places[PLACES_MAX];
int place_count;
thread_local bool inside;
bool running; /* main is */

void tell(int number, const char *function) {
    static int log = -2;
    const char *path = getenv("FAULT_LOG");
    if (log == -2)
        log = path ? open(path, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666) : -1;
    if (log >= 0)
        dprintf(log, "%d %s\n", number, function);
}

/* Of a new place the number from 1 on, else 0. */
int number_of(uint64_t place) {
    for (int i = 0; i < place_count; i++)
        if (places[i] == place)
            return 0;
    if (place_count == PLACES_MAX)
        return 0;
    places[place_count] = place;
    return ++place_count;
}

uint64_t place_of(const char *function) {
    void *frames[FRAMES_MAX];
    uint64_t hash = 14695981039346656037u;
    auto mix = [&](uint64_t value) { hash = (hash ^ value) * 1099511628211u; };
    for (const char *c = function; *c; c++)
        mix(static_cast<unsigned char>(*c));
    int count = backtrace(frames, FRAMES_MAX), depth = 0;
    for (int i = 0; i < count && depth < DEPTH; i++)
        if (in_program(frames[i])) {
            mix(reinterpret_cast<uintptr_t>(frames[i]) & 0xfffffff);
            depth++;
        }
    return hash;
}

/* Whether this call, which returns to that address, is to fail. */
bool fails(const char *function, const void *to) {
    static const char *wanted = getenv("FAULT");
    if (!running || !wanted || inside || !in_program(to))
        return false;
    inside = true;
    pthread_mutex_lock(&mutex);
    int number = number_of(place_of(function)), fault = atoi(wanted);
    bool now = number > 0 && number == fault;
    if (now || (number > 0 && fault == 0))
        tell(number, function);
    pthread_mutex_unlock(&mutex);
    inside = false;
    return now;
}

template <typename T> T real(T, const char *name) {
    return reinterpret_cast<T>(dlvsym(RTLD_NEXT, name, "GLIBC_2.2.5"));
}

} // namespace

#define FAILS(name) fails(name, __builtin_return_address(0))
#define REAL(name) static auto real_##name = reinterpret_cast<decltype(&name)>(dlsym_of_libc(#name))

extern "C" void *__libc_malloc(size_t);
extern "C" void *__libc_calloc(size_t, size_t);
extern "C" void *__libc_realloc(void *, size_t);

namespace {

typedef void *dlsym_function(void *, const char *);

/* The program's dlsym is ours, below. */
dlsym_function *true_dlsym() {
    static dlsym_function *found =
        reinterpret_cast<dlsym_function *>(dlvsym(RTLD_NEXT, "dlsym", "GLIBC_2.2.5"));
    return found;
}

void *dlsym_of_libc(const char *name) {
    return true_dlsym()(RTLD_NEXT, name);
}

/* --- OpenGL: what makes objects --------------------------------------------------------------- */

GLenum pending_error;

GLenum (*real_GetError)();

GLenum APIENTRY get_error() {
    GLenum error = pending_error ? pending_error : real_GetError();
    pending_error = 0;
    return error;
}

/* A wrapper for a function that gives nothing back: it does nothing, and there is an error. */
#define OUT_OF_MEMORY(name, type, parameters, arguments)                                           \
    type real_##name;                                                                              \
    void APIENTRY wrap_##name parameters {                                                         \
        if (FAILS("gl" #name))                                                                     \
            pending_error = GL_OUT_OF_MEMORY;                                                      \
        else                                                                                       \
            real_##name arguments;                                                                 \
    }

OUT_OF_MEMORY(TextureStorage2D, PFNGLTEXTURESTORAGE2DPROC,
              (GLuint t, GLsizei l, GLenum f, GLsizei w, GLsizei h), (t, l, f, w, h))
OUT_OF_MEMORY(TextureStorage3D, PFNGLTEXTURESTORAGE3DPROC,
              (GLuint t, GLsizei l, GLenum f, GLsizei w, GLsizei h, GLsizei d), (t, l, f, w, h, d))
OUT_OF_MEMORY(TextureStorage3DMultisample, PFNGLTEXTURESTORAGE3DMULTISAMPLEPROC,
              (GLuint t, GLsizei s, GLenum f, GLsizei w, GLsizei h, GLsizei d, GLboolean b),
              (t, s, f, w, h, d, b))
OUT_OF_MEMORY(NamedBufferStorage, PFNGLNAMEDBUFFERSTORAGEPROC,
              (GLuint b, GLsizeiptr s, const void *d, GLbitfield f), (b, s, d, f))

PFNGLCHECKNAMEDFRAMEBUFFERSTATUSPROC real_CheckNamedFramebufferStatus;

GLenum APIENTRY wrap_CheckNamedFramebufferStatus(GLuint framebuffer, GLenum target) {
    return FAILS("glCheckNamedFramebufferStatus")
               ? GL_FRAMEBUFFER_UNSUPPORTED
               : real_CheckNamedFramebufferStatus(framebuffer, target);
}

PFNGLGETPROGRAMIVPROC real_GetProgramiv;

/* A program that does not link, for which the driver is silent. */
void APIENTRY wrap_GetProgramiv(GLuint program, GLenum name, GLint *value) {
    real_GetProgramiv(program, name, value);
    if (name == GL_LINK_STATUS && FAILS("glLinkProgram"))
        *value = GL_FALSE;
}

PFNGLGETGRAPHICSRESETSTATUSPROC real_GetGraphicsResetStatus;

GLenum APIENTRY wrap_GetGraphicsResetStatus() {
    return FAILS("glGetGraphicsResetStatus") ? GL_UNKNOWN_CONTEXT_RESET
                                             : real_GetGraphicsResetStatus();
}

EGLContext (*real_CreateContext)(EGLDisplay, EGLConfig, EGLContext, const EGLint *);

EGLContext create_context(EGLDisplay display, EGLConfig config, EGLContext share,
                          const EGLint *attributes) {
    return FAILS("eglCreateContext") ? EGL_NO_CONTEXT
                                     : real_CreateContext(display, config, share, attributes);
}

template <typename T> void *wrapped(T &real, T wrapper, void *found) {
    real = reinterpret_cast<T>(found);
    return reinterpret_cast<void *>(wrapper);
}

__eglMustCastToProperFunctionPointerType (*real_GetProcAddress)(const char *);

__eglMustCastToProperFunctionPointerType get_proc_address(const char *name) {
    void *found = reinterpret_cast<void *>(real_GetProcAddress(name)), *given = found;
#define WRAP(function)                                                                             \
    if (found && strcmp(name, "gl" #function) == 0)                                                \
        given = wrapped(real_##function, decltype(real_##function)(wrap_##function), found);
    WRAP(TextureStorage2D)
    WRAP(TextureStorage3D)
    WRAP(TextureStorage3DMultisample)
    WRAP(NamedBufferStorage)
    WRAP(CheckNamedFramebufferStatus)
    WRAP(GetProgramiv)
    WRAP(GetGraphicsResetStatus)
    if (found && strcmp(name, "glGetError") == 0)
        given = wrapped(real_GetError, get_error, found);
    if (found && strcmp(name, "eglCreateContext") == 0)
        given = wrapped(real_CreateContext, create_context, found);
    return reinterpret_cast<__eglMustCastToProperFunctionPointerType>(given);
}

} // namespace

/* --- libc and libstdc++ ----------------------------------------------------------------------- */

extern "C" {

void *dlsym(void *library, const char *name) noexcept {
    void *found = true_dlsym()(library, name);
    if (found && strcmp(name, "eglGetProcAddress") == 0)
        return wrapped(real_GetProcAddress, get_proc_address, found);
    return found;
}

void *dlopen(const char *name, int flags) {
    REAL(dlopen);
    return FAILS("dlopen") ? nullptr : real_dlopen(name, flags);
}

void *malloc(size_t size) {
    if (FAILS("malloc")) {
        errno = ENOMEM;
        return nullptr;
    }
    return __libc_malloc(size);
}

void *calloc(size_t count, size_t size) {
    if (FAILS("calloc")) {
        errno = ENOMEM;
        return nullptr;
    }
    return __libc_calloc(count, size);
}

void *realloc(void *old, size_t size) {
    if (FAILS("realloc")) {
        errno = ENOMEM;
        return nullptr;
    }
    return __libc_realloc(old, size);
}

#define FILE_CALL(result, name, parameters, arguments, failure, reason)                            \
    result name parameters {                                                                       \
        REAL(name);                                                                                \
        if (FAILS(#name)) {                                                                        \
            errno = reason;                                                                        \
            return failure;                                                                        \
        }                                                                                          \
        return real_##name arguments;                                                              \
    }

FILE_CALL(FILE *, fopen, (const char *path, const char *mode), (path, mode), nullptr, EMFILE)
FILE_CALL(FILE *, fdopen, (int file, const char *mode) noexcept, (file, mode), nullptr, EMFILE)
FILE_CALL(FILE *, open_memstream, (char **to, size_t *size) noexcept, (to, size), nullptr, ENOMEM)
FILE_CALL(size_t, fread, (void *to, size_t size, size_t count, FILE *file), (to, size, count, file),
          0, EIO)
FILE_CALL(size_t, fwrite, (const void *from, size_t size, size_t count, FILE *file),
          (from, size, count, file), 0, ENOSPC)
FILE_CALL(int, fflush, (FILE * file), (file), EOF, ENOSPC)
FILE_CALL(ssize_t, read, (int file, void *to, size_t size), (file, to, size), -1, EIO)
FILE_CALL(ssize_t, pread, (int file, void *to, size_t size, off_t at), (file, to, size, at), -1,
          EIO)
FILE_CALL(ssize_t, write, (int file, const void *from, size_t size), (file, from, size), -1, ENOSPC)
FILE_CALL(int, fsync, (int file), (file), -1, EIO)
FILE_CALL(int, rename, (const char *from, const char *to) noexcept, (from, to), -1, EIO)
FILE_CALL(int, linkat, (int a, const char *from, int b, const char *to, int flags) noexcept,
          (a, from, b, to, flags), -1, EIO)
FILE_CALL(int, unlink, (const char *path) noexcept, (path), -1, EIO)
FILE_CALL(int, mkdir, (const char *path, mode_t mode) noexcept, (path, mode), -1, ENOSPC)
FILE_CALL(char *, realpath, (const char *path, char *to) noexcept, (path, to), nullptr, EIO)
FILE_CALL(int, fstat, (int file, struct stat *to) noexcept, (file, to), -1, EIO)
FILE_CALL(int, stat, (const char *path, struct stat *to) noexcept, (path, to), -1, EIO)

int open(const char *path, int flags, ...) {
    REAL(open);
    va_list more;
    va_start(more, flags);
    mode_t mode = flags & (O_CREAT | O_TMPFILE) ? va_arg(more, mode_t) : 0;
    va_end(more);
    if (FAILS("open")) {
        errno = EMFILE;
        return -1;
    }
    return real_open(path, flags, mode);
}

int close(int file) {
    REAL(close);
    bool bad = FAILS("close");
    int result = real_close(file);
    errno = bad ? EIO : errno;
    return bad ? -1 : result;
}

int fclose(FILE *file) {
    REAL(fclose);
    bool bad = FAILS("fclose");
    int result = real_fclose(file);
    errno = bad ? ENOSPC : errno;
    return bad ? EOF : result;
}

struct turn {
    void *(*start)(void *);
    void *argument;
    sem_t done;
};

static void *take_turn(void *context) {
    turn *own = static_cast<turn *>(context);
    void *result = own->start(own->argument);
    sem_post(&own->done);
    return result;
}

/* The program's threads take turns: who begins one waits until its work is done. Else chance would
 * decide which thread makes a call, and so from where. */
int pthread_create(pthread_t *thread, const pthread_attr_t *attributes, void *(*start)(void *),
                   void *argument) {
    REAL(pthread_create);
    if (FAILS("pthread_create"))
        return EAGAIN;
    if (!running || !in_program(__builtin_return_address(0)))
        return real_pthread_create(thread, attributes, start, argument);
    turn own = {start, argument, {}};
    sem_init(&own.done, 0, 0);
    int error = real_pthread_create(thread, attributes, take_turn, &own);
    while (!error && sem_wait(&own.done) != 0)
        ;
    sem_destroy(&own.done);
    return error;
}

typedef int main_function(int, char **, char **);

static main_function *real_main;

static int begin_main(int count, char **arguments, char **environment) {
    running = true;
    int status = real_main(count, arguments, environment);
    running = false;
    return status;
}

int __libc_start_main(main_function *main, int count, char **arguments, void (*init)(void),
                      void (*fini)(void), void (*loader_fini)(void), void *stack_end) {
    static auto real =
        reinterpret_cast<decltype(&__libc_start_main)>(dlsym_of_libc("__libc_start_main"));
    real_main = main;
    return real(begin_main, count, arguments, init, fini, loader_fini, stack_end);
}

} // extern "C"

void *operator new(size_t size) {
    void *memory = FAILS("operator new") ? nullptr : __libc_malloc(size ? size : 1);
    if (!memory)
        throw std::bad_alloc();
    return memory;
}
