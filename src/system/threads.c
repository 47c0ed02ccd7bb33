/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Can the threads of a run be started, and are their stacks large enough? */

#define _GNU_SOURCE

#include <errno.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

/* What the threads that are tried have in common. */
struct trial {
   pthread_mutex_t lock;
   pthread_cond_t change;
   int may_end;
};

/* A thread that waits until all have been started. */
static void *wait_for_all(void *data)
{
   struct trial *self = data;
   pthread_mutex_lock(&self->lock);
   while (!self->may_end) pthread_cond_wait(&self->change, &self->lock);
   pthread_mutex_unlock(&self->lock);
   return NULL;
}

/* Size of a stack as OpenMP's environment variables give it: a number of kilobytes, or with B, K, M or G behind it.
   0: not given, or not understood, which OpenMP passes over. */
static size_t stack_size_of(const char *text)
{
   char *end;
   if (text == NULL) return 0;
   errno = 0;
   const unsigned long number = strtoul(text, &end, 10);
   if (end == text || errno != 0) return 0;
   int shift = 10;
   end += strspn(end, " \t\n");
   if (*end != '\0') {
      const char units[] = "bBkKmMgG";
      const char *unit = strchr(units, *end);
      if (unit == NULL || end[1 + strspn(end + 1, " \t\n")] != '\0') return 0;
      shift = 10*(int)((unit - units)/2);
   }
   return number << shift >> shift == number ? (size_t)number << shift : 0;
}

/* Attributes of the threads that OpenMP will start; and how large their stacks are [bytes], 0 if that cannot be said. */
static size_t set_attributes(pthread_attr_t *attributes)
{
   const char *given = getenv("OMP_STACKSIZE");
   if (given == NULL) given = getenv("GOMP_STACKSIZE");
   size_t size = stack_size_of(given);
   /* a size below the least is passed over, too */
   if (size > 0) pthread_attr_setstacksize(attributes, size);
   return pthread_attr_getstacksize(attributes, &size) == 0 ? size : 0;
}

/* Start so many threads at once, and end them. 0 or an error number; how many there were, and the size of their stacks. */
int adfric_try_threads(int n, int *n_started, double *stack_size)
{
   struct trial trial = {PTHREAD_MUTEX_INITIALIZER, PTHREAD_COND_INITIALIZER, 0};
   pthread_attr_t attributes;
   int number = pthread_attr_init(&attributes);
   *n_started = 0;
   *stack_size = 0;
   if (number != 0) return number;
   *stack_size = (double)set_attributes(&attributes);
   pthread_t *threads = malloc((size_t)n*sizeof *threads);
   if (threads == NULL) number = ENOMEM;
   while (number == 0 && *n_started < n) {
      number = pthread_create(&threads[*n_started], &attributes, wait_for_all, &trial);
      if (number == 0) (*n_started)++;
   }
   pthread_mutex_lock(&trial.lock);
   trial.may_end = 1;
   pthread_cond_broadcast(&trial.change);
   pthread_mutex_unlock(&trial.lock);
   for (int i = 0; i < *n_started; i++) pthread_join(threads[i], NULL);
   free(threads);
   pthread_attr_destroy(&attributes);
   return number;
}
