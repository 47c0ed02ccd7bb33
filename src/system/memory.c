/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Memory that a process may still have. */

#define _DEFAULT_SOURCE

#include <stdint.h>
#include <stdio.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

/* Can so many bytes be had at once? */
int adfric_has_room(double n_bytes)
{
   if (!(n_bytes < (double)(SIZE_MAX/4))) return 0;
   if (n_bytes < 1) return 1;
   void *room = mmap(NULL, (size_t)n_bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
   if (room == MAP_FAILED) return 0;
   munmap(room, (size_t)n_bytes);
   return 1;
}

/* Bytes that the limit of the process leaves; negative if there is none, or it cannot be said. */
double adfric_room_below_limit(void)
{
   struct rlimit limit;
   unsigned long n_pages;
   if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return -1.0;
   FILE *file = fopen("/proc/self/statm", "r");
   if (file == NULL) return -1.0;
   const int n_read = fscanf(file, "%lu", &n_pages);
   fclose(file);
   if (n_read != 1) return -1.0;
   const double room = (double)limit.rlim_cur - (double)n_pages*(double)sysconf(_SC_PAGESIZE);
   return room > 0.0 ? room : 0.0;
}
