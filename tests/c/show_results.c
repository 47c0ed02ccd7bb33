/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Solve an input and print what was found, a line of words for each array and attribute, for tests/program/c_results.py. */

#include <inttypes.h>

#include "check.h"

/* A text without blanks and line ends, as hexadecimal digits. */
static void show_text(const char *text)
{
   putchar('x');
   for (; *text != '\0'; text++) printf("%02x", (unsigned char)*text);
   putchar(' ');
}

/* The values of an array, the last dimension fastest, wherever they stand. */
static void show_values(const adfric_array *array)
{
   int64_t n = 1;
   for (int k = 0; k < array->rank; k++) n *= array->shape[k];
   for (int64_t i = 0; i < n; i++) {
      int64_t rest = i, place = 0;
      for (int k = array->rank - 1; k >= 0; k--) {
         place += rest%array->shape[k]*array->strides[k];
         rest /= array->shape[k];
      }
      if (array->values != NULL) printf("%a ", array->values[place]);
      else printf("%d ", array->states[place]);
   }
}

static void show_array(const adfric_array *array)
{
   printf("array ");
   show_text(array->name);
   show_text(array->unit);
   show_text(array->long_name);
   show_text(array->flag_meanings);
   printf("%d %d %s %d ", array->first_flag, array->role, array->values != NULL ? "values" : "states", array->rank);
   for (int k = 0; k < array->rank; k++) show_text(array->dimensions[k]);
   for (int k = 0; k < array->rank; k++) printf("%" PRId64 " ", array->shape[k]);
   show_values(array);
   printf("\n");
}

int main(int n_words, char **words)
{
   adfric_case self = 0;
   adfric_results found = 0;
   adfric_array array;
   adfric_attribute_info attribute;
   int32_t n = 0;
   CHECK(n_words == 2);
   CHECK_OK(adfric_read(words[1], &self));
   CHECK_OK(adfric_solve(self, 0, NULL, NULL, &found));
   CHECK_OK(adfric_close_case(self));
   CHECK_OK(adfric_array_count(found, &n));
   for (int32_t i = 0; i < n; i++) {
      CHECK_OK(adfric_array_at(found, i, &array));
      show_array(&array);
   }
   CHECK_OK(adfric_attribute_count(found, &n));
   for (int32_t i = 0; i < n; i++) {
      CHECK_OK(adfric_attribute(found, i, &attribute));
      printf("attribute ");
      show_text(attribute.name);
      if (attribute.text != NULL) show_text(attribute.text);
      else printf("%a", attribute.number);
      printf("\n");
   }
   CHECK_OK(adfric_close_results(found));
   return 0;
}
