/* What neither Fortran nor HDF5 says about files: kinds, locks, free space, and a move that overwrites nothing. */

#define _DEFAULT_SOURCE

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <time.h>
#include <unistd.h>

/* Copy a text that always ends with a null character. */
static void copy_text(char *to, size_t size, const char *from)
{
   strncpy(to, from, size - 1);
   to[size - 1] = '\0';
}

/* 0: nothing there that can be seen, 1: a regular file, 2: something else, such as a link that leads nowhere. */
int adfric_kind_of_path(const char *path)
{
   struct stat entry;
   if (stat(path, &entry) == 0) return S_ISREG(entry.st_mode) ? 1 : 2;
   return lstat(path, &entry) == 0 ? 2 : 0;
}

/* Device and inode of what stands at a path, by whatever name; zeros if there is nothing. */
void adfric_identify(const char *path, int64_t id[2])
{
   struct stat entry;
   const int is_there = stat(path, &entry) == 0;
   id[0] = is_there ? (int64_t)entry.st_dev : 0;
   id[1] = is_there ? (int64_t)entry.st_ino : 0;
}

/* Does another process, or another part of this one, hold the lock that HDF5 takes on files it writes? */
int adfric_is_locked(const char *path)
{
   /* without waiting for whoever opens the other end of a pipe */
   const int file = open(path, O_RDONLY | O_NONBLOCK);
   if (file < 0) return 0;
   const int is_locked = flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
   close(file);
   return is_locked;
}

/* Bytes that this user may still write into a folder; negative if it cannot be said. */
double adfric_free_space(const char *folder)
{
   struct statvfs system;
   if (statvfs(folder, &system) != 0 || system.f_blocks == 0) return -1.0;
   return (double)system.f_bavail * (double)system.f_frsize;
}

/* Bring a file to the disk itself. 0 or an error number. */
static int synchronise(const char *path)
{
   const int file = open(path, O_RDONLY | O_NONBLOCK);
   if (file < 0) return errno;
   const int number = fsync(file) == 0 ? 0 : errno;
   close(file);
   /* some file systems cannot do it */
   return number == EINVAL || number == ENOTSUP || number == ENOSYS ? 0 : number;
}

/* Rename a file; what stands at the new name is overwritten only if asked for. 0 or an error number. */
int adfric_move_file(const char *from, const char *to, int overwrite)
{
   /* the old results go only when the new ones are safe */
   const int number = synchronise(from);
   if (number != 0) return number;
   if (!overwrite) {
      if (link(from, to) == 0) return unlink(from) == 0 ? 0 : errno;
      if (errno == EEXIST) return EEXIST;
      /* A file system without hard links. */
      if (adfric_kind_of_path(to) != 0) return EEXIST;
   }
   return rename(from, to) == 0 ? 0 : errno;
}

/* Remove a file. 0 or an error number. */
int adfric_remove_file(const char *path)
{
   return unlink(path) == 0 ? 0 : errno;
}

/* What an error number means. */
void adfric_error_text(int number, char *text, size_t size)
{
   copy_text(text, size, strerror(number));
}

/* The time now, as in 2025-01-31T13:45:00Z. */
void adfric_utc_time(char *text, size_t size)
{
   const time_t now = time(NULL);
   struct tm parts;
   if (gmtime_r(&now, &parts) == NULL || strftime(text, size, "%Y-%m-%dT%H:%M:%SZ", &parts) == 0) text[0] = '\0';
}

/* A write over the limit of the file size shall be an error, not the end of the process. */
void adfric_ignore_file_size_signal(void)
{
   signal(SIGXFSZ, SIG_IGN);
}
