/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Several threads at once, and calls that are stopped. */

#include <pthread.h>

#include "check.h"

enum { n_threads = 8, n_rounds = 20, n_loads = 200 };

/* Results of the case that each thread solves, of the tip with its number. */
static double radii[n_threads][n_loads];

static adfric_case open_tip(double radius, int n)
{
   adfric_case tip = 0;
   double loads[n_loads];
   for (int i = 0; i < n; i++) loads[i] = 1e-9*i;
   CHECK_OK(adfric_open("sphere", &tip));
   CHECK_OK(adfric_set_real(tip, "radius", radius));
   CHECK_OK(adfric_set_real(tip, "contact_modulus", 1e9));
   CHECK_OK(adfric_set_real(tip, "work_of_adhesion", 0.05));
   CHECK_OK(adfric_set_real(tip, "adhesion_stress", 1e8));
   CHECK_OK(adfric_sweep(tip, "load", n, loads));
   return tip;
}

static void solve_tip(int number, double *values)
{
   adfric_results found = 0;
   adfric_array radius;
   adfric_case tip = open_tip(1e-6*(number + 1), n_loads);
   CHECK_OK(adfric_solve(tip, 1, NULL, NULL, &found));
   CHECK_OK(adfric_array_of(found, "contact_radius", &radius));
   memcpy(values, radius.values, sizeof radii[0]);
   CHECK_OK(adfric_close_results(found));
   CHECK_OK(adfric_close_case(tip));
}

/* Each thread has cases of its own, and errors of its own. */
static void *work_alone(void *data)
{
   const int number = *(const int *)data;
   double values[n_loads];
   char name[16], expected[64];
   snprintf(name, sizeof name, "radius_%d", number);
   snprintf(expected, sizeof expected, "unknown variable, given '%s'", name);
   for (int k = 0; k < n_rounds; k++) {
      adfric_case other = 0;
      adfric_variable_info variable;
      solve_tip(number, values);
      CHECK(memcmp(values, radii[number], sizeof values) == 0);
      CHECK_OK(adfric_open("hertz", &other));
      CHECK_REFUSED(adfric_set_real(other, name, 1), expected);
      CHECK_OK(adfric_variable("wave_1d", number, &variable));
      CHECK_OK(adfric_close_case(other));
   }
   return NULL;
}

static void test_own_cases(void)
{
   pthread_t threads[n_threads];
   int numbers[n_threads];
   for (int i = 0; i < n_threads; i++) {
      numbers[i] = i;
      solve_tip(i, radii[i]);
   }
   for (int i = 0; i < n_threads; i++) CHECK(pthread_create(&threads[i], NULL, work_alone, &numbers[i]) == 0);
   for (int i = 0; i < n_threads; i++) CHECK(pthread_join(threads[i], NULL) == 0);
}

/* A case that all threads want to use: who comes while another one uses it is refused, and nothing else happens. */
static void *work_on_one(void *data)
{
   const adfric_case tip = *(const adfric_case *)data;
   for (int k = 0; k < 500; k++) {
      const int status = adfric_set_real(tip, "radius", 1e-6*(k + 1));
      if (status == ADFRIC_OK) continue;
      CHECK_REFUSED(status, "another thread uses the case at the moment, allowed: one thread at a time");
   }
   return NULL;
}

/* Results that all threads read, and that one of them closes. */
static void *read_together(void *data)
{
   const adfric_results found = *(const adfric_results *)data;
   adfric_array array;
   for (int k = 0; k < 500; k++) {
      CHECK_OK(adfric_array_of(found, "contact_radius", &array));
      CHECK(array.shape[0] == n_loads && array.values[n_loads - 1] > array.values[0]);
   }
   return NULL;
}

/* A case that all threads want to close: one of them can. */
static void *close_one(void *data)
{
   return adfric_close_case(*(const adfric_case *)data) == ADFRIC_OK ? data : NULL;
}

static void test_shared_handles(void)
{
   pthread_t threads[n_threads];
   void *closed;
   int n_closed = 0;
   adfric_results found = 0;
   adfric_case tip = open_tip(1e-6, n_loads);
   CHECK_OK(adfric_solve(tip, 2, NULL, NULL, &found));
   for (int i = 0; i < n_threads; i++) CHECK(pthread_create(&threads[i], NULL, work_on_one, &tip) == 0);
   for (int i = 0; i < n_threads; i++) CHECK(pthread_join(threads[i], NULL) == 0);
   for (int i = 0; i < n_threads; i++) CHECK(pthread_create(&threads[i], NULL, read_together, &found) == 0);
   for (int i = 0; i < n_threads; i++) CHECK(pthread_join(threads[i], NULL) == 0);
   for (int i = 0; i < n_threads; i++) CHECK(pthread_create(&threads[i], NULL, close_one, &tip) == 0);
   for (int i = 0; i < n_threads; i++) {
      CHECK(pthread_join(threads[i], &closed) == 0);
      n_closed += closed != NULL;
   }
   CHECK(n_closed == 1);
   CHECK_OK(adfric_close_results(found));
}

/* What a caller's function sees of a call. */
struct watch {
   adfric_case tip;
   int n_calls, stops;
   int64_t n_done, n_points;
};

static int tell(void *context, int64_t n_done, int64_t n_points)
{
   struct watch *watch = context;
   adfric_results found;
   CHECK(n_done >= watch->n_done && n_done <= n_points);
   watch->n_calls++;
   watch->n_done = n_done;
   watch->n_points = n_points;
   /* the case is in use */
   CHECK_REFUSED(adfric_solve(watch->tip, 1, NULL, NULL, &found), "another thread uses the case at the moment");
   return watch->stops;
}

static void test_progress(void)
{
   struct watch watch = {0, 0, 0, 0, 0};
   adfric_results found = 0;
   adfric_array status;
   watch.tip = open_tip(1e-6, n_loads);
   CHECK_OK(adfric_solve(watch.tip, 1, tell, &watch, &found));
   CHECK(watch.n_calls >= 2 && watch.n_done == n_loads && watch.n_points == n_loads);
   CHECK_OK(adfric_close_results(found));
   /* it stops the call; nothing is found then, and the case is as before */
   watch.stops = 1;
   watch.n_done = 0;
   found = 42;
   CHECK(adfric_solve(watch.tip, 1, tell, &watch, &found) == ADFRIC_STOPPED);
   CHECK(strcmp(adfric_message(), "the call was stopped before all points were solved") == 0 && found == 42);
   CHECK_OK(adfric_solve(watch.tip, 0, NULL, NULL, &found));
   CHECK_OK(adfric_array_of(found, "status", &status));
   for (int i = 0; i < n_loads; i++) CHECK(status.states[i] == ADFRIC_SOLVED);
   CHECK_OK(adfric_close_results(found));
   CHECK_OK(adfric_close_case(watch.tip));
}

/* Another thread stops a call that would take long. */
static void *stop_it(void *data)
{
   const adfric_case tip = *(const adfric_case *)data;
   for (;;) {
      CHECK(adfric_stop(tip) == ADFRIC_OK);
      int64_t n;
      /* the call has come back, and the case is free */
      if (adfric_point_count(tip, &n) == ADFRIC_OK && n == 1) return NULL;
   }
}

static void test_stop(void)
{
   enum { n = 3000000 };
   double *loads = malloc(n*sizeof *loads);
   pthread_t thread;
   adfric_results found = 42;
   adfric_case tip = open_tip(1e-6, 1);
   CHECK(loads != NULL);
   for (int i = 0; i < n; i++) loads[i] = 1e-12*i;
   CHECK_OK(adfric_set_word(tip, "theory", "maugis_dugdale"));
   CHECK_OK(adfric_sweep(tip, "load", n, loads));
   CHECK(pthread_create(&thread, NULL, stop_it, &tip) == 0);
   int status;
   while ((status = adfric_solve(tip, 2, NULL, NULL, &found)) == ADFRIC_BAD_INPUT) continue;
   CHECK(status == ADFRIC_STOPPED && found == 42);
   while (adfric_set_real(tip, "load", 0) == ADFRIC_BAD_INPUT) continue;
   CHECK(pthread_join(thread, NULL) == 0);
   /* what came too late stops nothing */
   CHECK_OK(adfric_solve(tip, 1, NULL, NULL, &found));
   CHECK_OK(adfric_close_results(found));
   CHECK_OK(adfric_close_case(tip));
   free(loads);
}

int main(void)
{
   test_own_cases();
   test_shared_handles();
   test_progress();
   test_stop();
   return 0;
}
