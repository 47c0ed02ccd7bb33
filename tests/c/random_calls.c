/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Calls that somebody might make by mistake, drawn by chance, from several threads at once: each gives back one of the statuses,
   with a text where it is not ADFRIC_OK, and nothing else happens. */

#include <pthread.h>

#include "check.h"

enum { n_threads = 4, n_calls = 4000, n_handles = 6 };

/* Handles that all threads take from and put back, closed ones among them. They are mixed up on purpose. */
static int64_t handles[n_handles];
static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;

static const char *const models[] = {"sphere", "hertz", "wave_1d", "wavy_sliding", "surface_elastic", "spere", "", NULL};
static const char *const names[] = {"radius", "load", "contact_modulus", "work_of_adhesion", "theory", "kind", "heights",
                                    "amplitudes", "profiles", "n_r", "operating%load", "radios", "%", "&operating load", "", NULL};
static const char *const words[] = {"jkr", "line", "wave_2d", "stable", "", "'", NULL};
static const char *const texts[] = {"&job model = 'sphere' /\n&sphere radius = 1, contact_modulus = 1, work_of_adhesion = 0 /\n"
                                    "&operating load = 1 /\n", "&job model = 'hertz' /", "&surface kind = 'paraboloid' /\n&solid contact_modulus = 1e9 /",
                                    "&surface kind = 'heights', length_x = 1, length_y = 1 /", "&job", "/", "'", "", NULL};
static const double numbers[] = {1, 1e-6, 1e9, 0, -1, 0.5, 1e300, -1e-300, NAN, INFINITY};

/* Xorshift (Marsaglia 2003): a number from 0 to n - 1. */
static int draw(uint64_t *state, int n)
{
   *state ^= *state << 13;
   *state ^= *state >> 7;
   *state ^= *state << 17;
   return (int)(*state%(uint64_t)n);
}

#define ANY(state, list) (list)[draw((state), (int)(sizeof (list)/sizeof (list)[0]))]

/* One of the handles, or a number that is none. */
static int64_t any_handle(uint64_t *state)
{
   if (draw(state, 10) == 0) return (int64_t)*state;
   pthread_mutex_lock(&lock);
   const int64_t handle = handles[draw(state, n_handles)];
   pthread_mutex_unlock(&lock);
   return handle;
}

/* Put a new handle in the place of another one, which is closed. */
static int keep_handle(uint64_t *state, int status, int64_t handle)
{
   if (status != ADFRIC_OK) return status;
   const int place = draw(state, n_handles);
   pthread_mutex_lock(&lock);
   const int64_t other = handles[place];
   handles[place] = handle;
   pthread_mutex_unlock(&lock);
   if (adfric_close_case(other) != ADFRIC_OK) adfric_close_results(other);
   return adfric_model_count(&(int32_t){0});
}

/* Results have few points, and are read as far as they go. */
static int solve(uint64_t *state, int64_t handle)
{
   adfric_results found = 0;
   int64_t n = 0;
   int status = adfric_point_count(handle, &n);
   if (status != ADFRIC_OK || n > 100) return status;
   status = adfric_solve(handle, draw(state, 4) - 1, NULL, NULL, &found);
   return keep_handle(state, status, found);
}

static int call(uint64_t *state)
{
   const int64_t shape[] = {draw(state, 6) - 1, draw(state, 6) - 1};
   double values[25];
   adfric_case opened = 0;
   adfric_array array;
   adfric_variable_info variable;
   adfric_attribute_info attribute;
   adfric_model_info model;
   adfric_result_info result;
   int32_t n;
   for (int i = 0; i < 25; i++) values[i] = ANY(state, numbers);
   int status;
   switch (draw(state, 23)) {
   case 0: status = adfric_open(ANY(state, models), &opened); return keep_handle(state, status, opened);
   case 1: status = adfric_read_text(ANY(state, texts), &opened); return keep_handle(state, status, opened);
   case 2: return adfric_read(ANY(state, words), draw(state, 2) ? &opened : NULL);
   case 3: return adfric_close_case(any_handle(state));
   case 4: return adfric_close_results(any_handle(state));
   case 5: return adfric_set_integer(any_handle(state), ANY(state, names), draw(state, 9) - 4);
   case 6: return adfric_set_logical(any_handle(state), ANY(state, names), draw(state, 2));
   case 7: return adfric_set_word(any_handle(state), ANY(state, names), ANY(state, words));
   case 8: return adfric_set_array(any_handle(state), ANY(state, names), draw(state, 5) - 1, shape, values);
   case 9: return adfric_unset(any_handle(state), ANY(state, names));
   case 10: return adfric_sweep(any_handle(state), ANY(state, names), draw(state, 6) - 1, values);
   case 11: return adfric_sweep_together(any_handle(state), draw(state, 4) - 1, names + draw(state, 8), draw(state, 6) - 1, values);
   case 12: return adfric_check(any_handle(state));
   case 13: return adfric_array_count(any_handle(state), &n);
   case 14: return adfric_array_at(any_handle(state), draw(state, 60) - 1, &array);
   case 15: return adfric_array_of(any_handle(state), ANY(state, names), &array);
   case 16: return adfric_attribute(any_handle(state), draw(state, 20) - 1, &attribute);
   case 17: status = adfric_model(draw(state, 14) - 1, &model); return status;
   case 18: return adfric_variable(ANY(state, models), draw(state, 40) - 1, &variable);
   case 19: return adfric_variable_of(any_handle(state), ANY(state, names), &variable);
   case 20: return adfric_describe(any_handle(state), ANY(state, names), &result);
   case 21:
      status = adfric_open_scene(ANY(state, texts), draw(state, 4) - 1, names + draw(state, 8), &opened);
      return keep_handle(state, status, opened);
   default: return draw(state, 4) > 0 ? adfric_set_real(any_handle(state), ANY(state, names), ANY(state, numbers))
                                      : solve(state, any_handle(state));
   }
}

static void *call_often(void *data)
{
   uint64_t state = *(const uint64_t *)data;
   for (int i = 0; i < n_calls; i++) {
      const int status = call(&state);
      CHECK(status == ADFRIC_OK || status == ADFRIC_BAD_INPUT || status == ADFRIC_FAILED);
      CHECK((status == ADFRIC_OK) == (strlen(adfric_message()) == 0));
   }
   return NULL;
}

int main(int n_words, char **arguments)
{
   pthread_t threads[n_threads];
   uint64_t seeds[n_threads];
   const uint64_t first = n_words > 1 ? strtoull(arguments[1], NULL, 10) : 1;
   for (int i = 0; i < n_threads; i++) {
      seeds[i] = UINT64_C(0x9e3779b97f4a7c15)*(first*n_threads + (uint64_t)i);
      CHECK(pthread_create(&threads[i], NULL, call_often, &seeds[i]) == 0);
   }
   for (int i = 0; i < n_threads; i++) CHECK(pthread_join(threads[i], NULL) == 0);
   for (int i = 0; i < n_handles; i++)
      if (adfric_close_case(handles[i]) != ADFRIC_OK) adfric_close_results(handles[i]);
   return 0;
}
