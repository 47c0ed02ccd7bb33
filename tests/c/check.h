/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the tests of adfric.h have in common: a test ends with the first line that is not as it should be. */

#ifndef ADFRIC_TESTS_CHECK_H
#define ADFRIC_TESTS_CHECK_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "adfric.h"

#define CHECK(condition) check((condition), #condition, __FILE__, __LINE__)
/* A call that must succeed. */
#define CHECK_OK(call) check_status((call), ADFRIC_OK, "", #call, __FILE__, __LINE__)
/* A call that must be refused with words that are a part of the message. */
#define CHECK_REFUSED(call, words) check_status((call), ADFRIC_BAD_INPUT, (words), #call, __FILE__, __LINE__)

static inline void check(int is_right, const char *condition, const char *file, int line)
{
   if (is_right) return;
   fprintf(stderr, "%s:%d: not so: %s\n", file, line, condition);
   exit(1);
}

static inline void check_status(int status, int expected, const char *words, const char *call, const char *file, int line)
{
   const char *message = adfric_message();
   const int is_right = status == expected && strstr(message, words) != NULL && (status != ADFRIC_OK || message[0] == '\0');
   if (is_right) return;
   fprintf(stderr, "%s:%d: %s: status %d, expected %d; message \"%s\", expected \"%s\"\n", file, line, call, status, expected,
           message, words);
   exit(1);
}

/* Are two numbers equal but for round-off? */
static inline int is_close(double a, double b, double tolerance)
{
   return fabs(a - b) <= tolerance*fabs(b);
}

#endif
