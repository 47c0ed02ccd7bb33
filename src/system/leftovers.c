/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Files that are of no use if the program ends now, and one whose results stay: noted by who makes them, so that they are
   known where nothing can be asked any more. */

#define _XOPEN_SOURCE 700

#include <limits.h>
#include <pthread.h>
#include <stdatomic.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

enum { most_leftovers = 4 };

struct leftover {
   char path[PATH_MAX];
   /* is there a path? said last, and taken back first: who reads it may come at any time */
   atomic_int is_noted;
};

static struct leftover leftovers[most_leftovers], kept;

/* Held while such a file is made: it must not come when all are being removed. */
static pthread_mutex_t making = PTHREAD_MUTEX_INITIALIZER;
static _Thread_local int is_making = 0;

void adfric_begin_making(void)
{
   pthread_mutex_lock(&making);
   is_making = 1;
}

void adfric_end_making(void)
{
   is_making = 0;
   pthread_mutex_unlock(&making);
}

static void note(struct leftover *self, const char *path)
{
   if (strlen(path) >= sizeof self->path) return;
   strcpy(self->path, path);
   atomic_store(&self->is_noted, 1);
}

/* Note a file that is of no use if the program ends now. */
void adfric_note_leftover(const char *path)
{
   for (int i = 0; i < most_leftovers; i++) {
      if (atomic_load(&leftovers[i].is_noted)) continue;
      note(&leftovers[i], path);
      return;
   }
}

/* It is gone, or of use now. */
void adfric_forget_leftover(const char *path)
{
   for (int i = 0; i < most_leftovers; i++) {
      if (atomic_load(&leftovers[i].is_noted) && strcmp(leftovers[i].path, path) == 0) {
         atomic_store(&leftovers[i].is_noted, 0);
         return;
      }
   }
}

/* Note the file whose results stay if the program ends now; an empty path: there is none any more. */
void adfric_note_kept(const char *path)
{
   atomic_store(&kept.is_noted, 0);
   if (path[0] != '\0') note(&kept, path);
}

/* The file whose results stay; NULL if there is none. */
const char *adfric_kept(void)
{
   return atomic_load(&kept.is_noted) ? kept.path : NULL;
}

/* Remove what is of no use; the process ends then, and no more of it is made. Asks for no memory. A thread that makes a file
   is waited for, unless it is this one, but not for ever: it may wait for us. */
void adfric_remove_leftovers(void)
{
   struct timespec latest;
   clock_gettime(CLOCK_REALTIME, &latest);
   latest.tv_sec += 2;
   if (!is_making) (void)pthread_mutex_timedlock(&making, &latest);
   for (int i = 0; i < most_leftovers; i++) {
      if (atomic_load(&leftovers[i].is_noted)) unlink(leftovers[i].path);
   }
}
