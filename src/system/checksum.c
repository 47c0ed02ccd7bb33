/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A checksum of bytes: FNV-1a with 64 bits (G. Fowler, L. C. Noll, K.-P. Vo, D. Eastlake). */

#include <stddef.h>
#include <stdint.h>
#include <string.h>

/* The checksum of what came before and of these bytes. */
uint64_t adfric_add_to_checksum(uint64_t before, const unsigned char *bytes, size_t n)
{
   const uint64_t prime = 1099511628211u;
   uint64_t sum = before;
   for (size_t i = 0; i < n; i++) sum = (sum ^ bytes[i]) * prime;
   return sum;
}

/* One step of a faster sum, by words of eight bytes; it is one-to-one in the word and in what came before. */
static uint64_t step(uint64_t sum, uint64_t word)
{
   sum = (sum ^ word) * 0x9e3779b97f4a7c15u;
   return sum ^ (sum >> 32);
}

static uint64_t word_at(const unsigned char *bytes, size_t n)
{
   uint64_t word = 0;
   memcpy(&word, bytes, n);
   return word;
}

/* The sum of what came before and of these bytes. A change within one word always changes it, since all steps are
   one-to-one. Four sums run side by side, so that the processor need not wait for a step before the next one. */
uint64_t adfric_mix(uint64_t before, const unsigned char *bytes, size_t n)
{
   enum { width = sizeof before, n_lanes = 4 };
   uint64_t sum = before, lanes[n_lanes] = {1, 2, 3, 4};
   size_t i = 0;
   if (n >= n_lanes*width) {
      for (; i + n_lanes*width <= n; i += n_lanes*width) {
         for (int k = 0; k < n_lanes; k++) lanes[k] = step(lanes[k], word_at(bytes + i + k*width, width));
      }
      for (int k = 0; k < n_lanes; k++) sum = step(sum, lanes[k]);
   }
   for (; i + width <= n; i += width) sum = step(sum, word_at(bytes + i, width));
   return i < n ? step(sum, word_at(bytes + i, n - i)) : sum;
}
