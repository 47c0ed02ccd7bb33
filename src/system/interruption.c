/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Signals that ask a run to end. */

#define _DEFAULT_SOURCE

#include <signal.h>
#include <stddef.h>
#include <time.h>

/* Signals that come within this time are one request [s]: a batch system tells all processes of a job, and those pass it
   on to each other. */
static const double one_request = 1.0;

static volatile sig_atomic_t caught_signal = 0;
static struct timespec caught_at;

/* The first signal is kept, a later one ends the process. Calls only what is safe in here. */
static void keep_signal(int number)
{
   struct timespec now;
   clock_gettime(CLOCK_MONOTONIC, &now);
   if (caught_signal == 0) {
      caught_at = now;
      caught_signal = number;
      return;
   }
   const double elapsed = (double)(now.tv_sec - caught_at.tv_sec) + 1e-9*(double)(now.tv_nsec - caught_at.tv_nsec);
   if (elapsed < one_request) return;
   signal(number, SIG_DFL);
   raise(number);
}

/* Keep a signal instead of ending by it, unless it is ignored. */
static void catch_signal(int number)
{
   struct sigaction action, former;
   if (sigaction(number, NULL, &former) != 0 || former.sa_handler == SIG_IGN) return;
   action.sa_handler = keep_signal;
   sigemptyset(&action.sa_mask);
   action.sa_flags = SA_RESTART;
   sigaction(number, &action, NULL);
}

void adfric_catch_signals(void)
{
   caught_signal = 0;
   catch_signal(SIGTERM);
   catch_signal(SIGINT);
   catch_signal(SIGHUP);
}

/* The signal that came; 0 if none did. */
int adfric_caught_signal(void)
{
   return caught_signal;
}
