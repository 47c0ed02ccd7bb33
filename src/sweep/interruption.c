/* Signals that ask a run to end. */

#define _DEFAULT_SOURCE

#include <signal.h>
#include <stddef.h>

static volatile sig_atomic_t caught_signal = 0;

static void keep_signal(int number)
{
   caught_signal = number;
}

/* Keep a signal instead of ending by it, unless it is ignored; when it comes again, the process ends at once. */
static void catch_signal(int number)
{
   struct sigaction action, former;
   if (sigaction(number, NULL, &former) != 0 || former.sa_handler == SIG_IGN) return;
   action.sa_handler = keep_signal;
   sigemptyset(&action.sa_mask);
   action.sa_flags = (int)SA_RESETHAND | SA_RESTART;
   sigaction(number, &action, NULL);
}

void adfric_catch_signals(void)
{
   caught_signal = 0;
   catch_signal(SIGTERM);
   catch_signal(SIGINT);
}

/* The signal that came; 0 if none did. */
int adfric_caught_signal(void)
{
   return caught_signal;
}
