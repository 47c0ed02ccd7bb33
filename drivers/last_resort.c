/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The last resort: memory is exhausted, or a library ends the program. Then there is one line and status 3, and no file of
   no use is left behind. */

#define _GNU_SOURCE

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

/* exit status: a file that failed, or a machine that has too little */
enum { exit_machine = 3 };

/* What the main thread may need of its stack [bytes]. */
enum { stack_needed = 1 << 19 };

const char *adfric_kept(void);
void adfric_remove_leftovers(void);

/* Does the program watch over its end? It does when it is loaded: libraries may want memory before it begins. */
static atomic_int is_watched = 1;
/* The process itself: a copy of it, which a library may make, has nothing to remove. */
static pid_t own_process = 0;

/* Write a text into a file that is open. 0 or an error number. Calls only what is safe anywhere. */
int adfric_write_text(int file, const char *text, size_t n)
{
   while (n > 0) {
      const ssize_t written = write(file, text, n);
      if (written < 0 && errno == EINTR) continue;
      if (written < 0 && errno == EAGAIN) {
         /* a pipe that somebody else has told not to wait */
         struct pollfd place = {file, POLLOUT, 0};
         if (poll(&place, 1, -1) > 0 || errno == EINTR) continue;
      }
      if (written < 0) return errno;
      text += written;
      n -= (size_t)written;
   }
   return 0;
}

/* Write a text to the standard error. */
static void say(const char *text)
{
   (void)adfric_write_text(STDERR_FILENO, text, strlen(text));
}

/* End the program at once, whatever other threads do. Only the first thread that comes here has something to say. */
static _Noreturn void end_now(const char *reason)
{
   static atomic_flag has_ended = ATOMIC_FLAG_INIT;
   if (atomic_flag_test_and_set(&has_ended)) {
      for (;;) pause();
   }
   if (getpid() == own_process) adfric_remove_leftovers();
   if (reason != NULL) {
      const char *kept = adfric_kept();
      say("adfric: ");
      say(reason);
      if (kept != NULL) {
         say("; the results so far stay in ");
         say(kept);
         say(", --resume goes on with them");
      }
      say("\n");
   }
   _exit(exit_machine);
}

/* A library has called exit, and has said why. Its status means something else here. */
static void end_by_library(void)
{
   if (atomic_load(&is_watched) && getpid() == own_process) end_now(NULL);
}

/* Standard files that are closed must not become files of results: a write to them fails from now on. */
static void open_standard_files(void)
{
   for (int file = STDIN_FILENO; file <= STDERR_FILENO; file++) {
      if (fcntl(file, F_GETFD) != -1 || errno != EBADF) continue;
      if (open("/dev/null", file == STDIN_FILENO ? O_WRONLY : O_RDONLY) != file) _exit(exit_machine);
   }
}

/* Touch every page of the stack that may be needed: it could not grow any more when memory is exhausted. */
static void touch_stack(void)
{
   volatile char room[stack_needed];
   for (size_t i = 0; i < sizeof room; i += 1024) room[sizeof room - 1 - i] = 0;
}

/* Have the stack of the main thread. */
static void take_stack(void)
{
   struct rlimit limit;
   /* twice as much, for what stands on it already */
   if (getrlimit(RLIMIT_STACK, &limit) == 0 && limit.rlim_cur < 2*stack_needed)
      end_now("the stack of the program is too small, needed: 1024 kB; ulimit -s sets it");
   void *room = mmap(NULL, 2*stack_needed, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
   if (room == MAP_FAILED) end_now("out of memory");
   munmap(room, 2*stack_needed);
   touch_stack();
}

/* To be called first. */
void adfric_begin_watch(void)
{
   own_process = getpid();
   open_standard_files();
   if (atexit(end_by_library) != 0) end_now("out of memory");
   take_stack();
}

/* To be called last: the program ends in order. */
void adfric_end_watch(void)
{
   atomic_store(&is_watched, 0);
}

/* Whoever asks for memory in this process, a library or generated code that does not look whether it has got any, gets it
   or the program ends. What may be refused memory asks adfric_has_room before. The sanitizers have functions of their own. */
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)

void *__libc_malloc(size_t size);
void *__libc_calloc(size_t n, size_t size);
void *__libc_realloc(void *memory, size_t size);
void *__libc_memalign(size_t alignment, size_t size);
void *memalign(size_t alignment, size_t size);

static void *checked(void *memory, size_t size)
{
   if (memory == NULL && size > 0 && atomic_load(&is_watched)) end_now("out of memory");
   return memory;
}

void *malloc(size_t size)
{
   return checked(__libc_malloc(size), size);
}

void *calloc(size_t n, size_t size)
{
   return checked(__libc_calloc(n, size), n > 0 ? size : 0);
}

void *realloc(void *memory, size_t size)
{
   return checked(__libc_realloc(memory, size), size);
}

void *memalign(size_t alignment, size_t size)
{
   return checked(__libc_memalign(alignment, size), size);
}

void *aligned_alloc(size_t alignment, size_t size)
{
   return checked(__libc_memalign(alignment, size), size);
}

int posix_memalign(void **memory, size_t alignment, size_t size)
{
   if (alignment % sizeof(void *) != 0 || (alignment & (alignment - 1)) != 0 || alignment == 0) return EINVAL;
   void *found = checked(__libc_memalign(alignment, size), size);
   if (found == NULL && size > 0) return ENOMEM;
   *memory = found;
   return 0;
}

#endif
