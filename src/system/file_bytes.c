/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Bytes of a file as they stand on the disk, but for holes in it that are passed over. */

#define _GNU_SOURCE

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdint.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

uint64_t adfric_mix(uint64_t before, const unsigned char *bytes, size_t n);

/* Bytes that are read at once, a multiple of a word. */
enum { bytes_at_once = 1 << 16, word_bytes = 8 };

/* What is done with the bytes between two holes, piece by piece: their place in the file, and how many of them have been seen
   before, at the end of the last piece. */
struct visitor {
   void (*visit)(struct visitor *self, const unsigned char *bytes, size_t n, int64_t place);
   /* how many bytes at the end of a piece are shown once more before the next one */
   size_t n_again;
   uint64_t sum;
   const unsigned char *pattern;
   int64_t found_at;
   int n_found;
};

/* Show the bytes from one place to another. 0, an error number, or -1 if the file ends before. */
static int show_bytes(int file, int64_t from, int64_t to, struct visitor *visitor)
{
   unsigned char buffer[word_bytes + bytes_at_once];
   size_t n_kept = 0;
   while (from < to) {
      const size_t wanted = to - from < bytes_at_once ? (size_t)(to - from) : bytes_at_once;
      size_t n = 0;
      while (n < wanted) {
         const ssize_t n_read = pread(file, buffer + n_kept + n, wanted - n, (off_t)(from + (int64_t)n));
         if (n_read < 0 && errno == EINTR) continue;
         if (n_read < 0) return errno;
         if (n_read == 0) return -1;
         n += (size_t)n_read;
      }
      visitor->visit(visitor, buffer, n_kept + n, from - (int64_t)n_kept);
      from += (int64_t)n;
      n += n_kept;
      n_kept = n < visitor->n_again ? n : visitor->n_again;
      memmove(buffer, buffer + n - n_kept, n_kept);
   }
   return 0;
}

/* Show the first bytes of a file but for the holes, which rise and do not touch each other: first byte and number of bytes of
   each. 0, an error number, or -1 if the file is shorter, or is none. */
static int show_file(const char *path, int64_t size, int n_holes, const int64_t *holes, struct visitor *visitor)
{
   struct stat entry;
   const int file = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
   if (file < 0) return errno;
   int64_t from = 0;
   int number = fstat(file, &entry) == 0 ? 0 : errno;
   if (number == 0 && (!S_ISREG(entry.st_mode) || entry.st_size < size)) number = -1;
   for (int i = 0; i < n_holes && number == 0; i++) {
      number = show_bytes(file, from, holes[2*i], visitor);
      from = holes[2*i] + holes[2*i + 1];
   }
   if (number == 0) number = show_bytes(file, from, size, visitor);
   close(file);
   return number;
}

static void add_to_sum(struct visitor *self, const unsigned char *bytes, size_t n, int64_t place)
{
   (void)place;
   self->sum = adfric_mix(self->sum, bytes, n);
}

static void look_for_pattern(struct visitor *self, const unsigned char *bytes, size_t n, int64_t place)
{
   const unsigned char *found = bytes;
   while ((found = memmem(found, n - (size_t)(found - bytes), self->pattern, word_bytes)) != NULL) {
      if (self->n_found++ == 0) self->found_at = place + (found - bytes);
      found++;
   }
}

/* Checksum of the bytes. The result is that of show_file. */
int adfric_sum_file(const char *path, int64_t size, int n_holes, const int64_t *holes, uint64_t *sum)
{
   struct visitor visitor = {.visit = add_to_sum};
   const int number = show_file(path, size, n_holes, holes, &visitor);
   *sum = visitor.sum;
   return number;
}

/* Find a word among the bytes: where it stands first, and how often it does. The result is that of show_file. */
int adfric_find_word(const char *path, int64_t size, int n_holes, const int64_t *holes, const unsigned char *word,
                     int64_t *found_at, int *n_found)
{
   struct visitor visitor = {.visit = look_for_pattern, .n_again = word_bytes - 1, .pattern = word};
   const int number = show_file(path, size, n_holes, holes, &visitor);
   *found_at = visitor.found_at;
   *n_found = visitor.n_found;
   return number;
}

/* Read words from a place of a file. 0, an error number, or -1 if the file ends before, or is none. */
int adfric_read_words(const char *path, int64_t place, int64_t n, int64_t *words)
{
   struct stat entry;
   const int file = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
   if (file < 0) return errno;
   int number = fstat(file, &entry) == 0 ? 0 : errno;
   if (number == 0 && !S_ISREG(entry.st_mode)) number = -1;
   unsigned char *to = (unsigned char *)words;
   size_t left = (size_t)n*word_bytes;
   while (left > 0 && number == 0) {
      const ssize_t n_read = pread(file, to, left, (off_t)place);
      if (n_read < 0 && errno == EINTR) continue;
      if (n_read < 0) number = errno;
      if (n_read == 0) number = -1;
      if (n_read <= 0) break;
      to += n_read;
      place += n_read;
      left -= (size_t)n_read;
   }
   close(file);
   return number;
}

/* Open a regular file at its beginning, or a pipe if it may be one, without waiting for anybody: a pipe that nobody writes to is
   an empty file. Its number, minus the largest integer for anything else, or the negative of an error number. */
int adfric_open_to_read(const char *path, int takes_pipes)
{
   struct stat entry = {.st_mode = 0};
   const int file = open(path, O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
   if (file < 0) return -errno;
   if (fstat(file, &entry) == 0 && (S_ISREG(entry.st_mode) || (takes_pipes && S_ISFIFO(entry.st_mode)))) {
      /* what a pipe will bring is waited for */
      const int flags = fcntl(file, F_GETFL);
      if (flags >= 0 && fcntl(file, F_SETFL, flags & ~O_NONBLOCK) == 0) return file;
   }
   const int is_folder = S_ISDIR(entry.st_mode);
   close(file);
   return is_folder ? -EISDIR : -INT_MAX;
}

/* Read the next bytes of an open file, n at most. How many there were: 0 at its end; or the negative of an error number. */
int64_t adfric_read_next(int file, unsigned char *bytes, int64_t n)
{
   ssize_t n_read;
   do {
      n_read = read(file, bytes, (size_t)n);
   } while (n_read < 0 && errno == EINTR);
   return n_read < 0 ? -errno : (int64_t)n_read;
}

void adfric_close_file(int file)
{
   close(file);
}

/* Size of a file [bytes]; negative if it cannot be said. */
int64_t adfric_size_of_file(const char *path)
{
   struct stat entry;
   return stat(path, &entry) == 0 ? (int64_t)entry.st_size : -1;
}
