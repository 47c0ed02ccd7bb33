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

/* A faster sum, by words of eight bytes. Each step is one-to-one in the word and in what came before, so that a change
   within one word always changes the sum. */
uint64_t adfric_mix(uint64_t before, const unsigned char *bytes, size_t n)
{
   const uint64_t odd = 0x9e3779b97f4a7c15u;
   uint64_t sum = before;
   for (size_t i = 0; i < n; i += sizeof sum) {
      uint64_t word = 0;
      memcpy(&word, bytes + i, n - i < sizeof word ? n - i : sizeof word);
      sum = (sum ^ word) * odd;
      sum ^= sum >> 32;
   }
   return sum;
}
