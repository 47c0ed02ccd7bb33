/* A checksum of bytes: FNV-1a with 64 bits (G. Fowler, L. C. Noll, K.-P. Vo, D. Eastlake). */

#include <stddef.h>
#include <stdint.h>

/* The checksum of what came before and of these bytes. */
uint64_t adfric_add_to_checksum(uint64_t before, const unsigned char *bytes, size_t n)
{
   const uint64_t prime = 1099511628211u;
   uint64_t sum = before;
   for (size_t i = 0; i < n; i++) sum = (sum ^ bytes[i]) * prime;
   return sum;
}
