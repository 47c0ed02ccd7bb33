/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A counting semaphore: threads sleep until another one wakes them. */

#define _POSIX_C_SOURCE 200809L

#include <pthread.h>
#include <stdlib.h>

struct semaphore {
   pthread_mutex_t lock;
   pthread_cond_t change;
   long count;
};

/* NULL where the system has no room for one. */
struct semaphore *adfric_new_semaphore(long count)
{
   struct semaphore *self = malloc(sizeof *self);
   if (self == NULL) return NULL;
   self->count = count;
   if (pthread_mutex_init(&self->lock, NULL) != 0) {
      free(self);
      return NULL;
   }
   if (pthread_cond_init(&self->change, NULL) != 0) {
      pthread_mutex_destroy(&self->lock);
      free(self);
      return NULL;
   }
   return self;
}

void adfric_free_semaphore(struct semaphore *self)
{
   pthread_cond_destroy(&self->change);
   pthread_mutex_destroy(&self->lock);
   free(self);
}

/* Add one, and wake a thread that waits for it. */
void adfric_post_semaphore(struct semaphore *self)
{
   pthread_mutex_lock(&self->lock);
   self->count++;
   pthread_cond_signal(&self->change);
   pthread_mutex_unlock(&self->lock);
}

/* Sleep until there is one, and take it. */
void adfric_wait_semaphore(struct semaphore *self)
{
   pthread_mutex_lock(&self->lock);
   while (self->count == 0) pthread_cond_wait(&self->change, &self->lock);
   self->count--;
   pthread_mutex_unlock(&self->lock);
}
