/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What neither Fortran nor HDF5 says about files: kinds, locks, free space, and a move that overwrites nothing. */

/* for sync_file_range of Linux; elsewhere it asks for nothing more than the others */
#define _GNU_SOURCE
#define _DEFAULT_SOURCE
#define _XOPEN_SOURCE 700

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
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

/* Where a link leads to. 0, or an error number if the path is none or cannot be followed. */
int adfric_follow_link(const char *path, char *text, size_t size)
{
   struct stat entry;
   char target[PATH_MAX];
   if (lstat(path, &entry) != 0) return errno;
   if (!S_ISLNK(entry.st_mode)) return EINVAL;
   if (realpath(path, target) == NULL) return errno;
   if (strlen(target) >= size) return ENAMETOOLONG;
   copy_text(text, size, target);
   return 0;
}

/* Device and inode of what stands at a path, by whatever name; zeros if there is nothing. */
void adfric_identify(const char *path, int64_t id[2])
{
   struct stat entry;
   const int is_there = stat(path, &entry) == 0;
   id[0] = is_there ? (int64_t)entry.st_dev : 0;
   id[1] = is_there ? (int64_t)entry.st_ino : 0;
}

/* A lock is a lock of the whole of a file of its own: it ends with the process that holds it, however that ends. */

/* Does another process, or another part of this one, hold a lock? */
int adfric_is_locked(const char *path)
{
   /* without waiting for whoever opens the other end of a pipe */
   const int file = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
   if (file < 0) return 0;
   const int is_locked = flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
   close(file);
   return is_locked;
}

/* Take a lock. 0, -1 if another one holds it, or an error number. Where the file system has no locks, the lock
   has the number -1 and protects nothing. */
int adfric_take_lock(const char *path, int *lock)
{
   *lock = -1;
   for (;;) {
      const int file = open(path, O_RDWR | O_CREAT | O_NONBLOCK | O_CLOEXEC, 0666);
      struct stat held, named;
      if (file < 0) return errno;
      if (flock(file, LOCK_EX | LOCK_NB) != 0) {
         const int number = errno;
         close(file);
         if (number == EWOULDBLOCK) return -1;
         unlink(path);
         return 0;
      }
      /* whoever held it before may have removed the file after we opened it */
      if (fstat(file, &held) == 0 && stat(path, &named) == 0 && held.st_dev == named.st_dev
          && held.st_ino == named.st_ino) {
         *lock = file;
         return 0;
      }
      close(file);
   }
}

/* Give a lock back. */
void adfric_release_lock(const char *path, int lock)
{
   if (lock < 0) return;
   /* in this order: nobody gets a file that is about to go */
   unlink(path);
   close(lock);
}

/* Bytes that this user may still write into a folder; negative if it cannot be said. */
double adfric_free_space(const char *folder)
{
   struct statvfs system;
   if (statvfs(folder, &system) != 0 || system.f_blocks == 0) return -1.0;
   return (double)system.f_bavail * (double)system.f_frsize;
}

/* Path of a file as seen from the folder of another one: relative if it is in that folder or below it, else absolute.
   0 or an error number; both folders must exist. */
int adfric_path_from(const char *folder, const char *path, char *text, size_t size)
{
   char from[PATH_MAX], to[PATH_MAX];
   if (realpath(folder, from) == NULL || realpath(path, to) == NULL) return errno;
   const size_t n = strcmp(from, "/") == 0 ? 0 : strlen(from);
   const char *result = strncmp(from, to, n) == 0 && to[n] == '/' ? to + n + 1 : to;
   if (strlen(result) >= size) return ENAMETOOLONG;
   copy_text(text, size, result);
   return 0;
}

/* Bring a file to the disk itself. 0 or an error number. */
int adfric_synchronise(const char *path)
{
   const int file = open(path, O_RDONLY | O_NONBLOCK);
   if (file < 0) return errno;
   const int number = fsync(file) == 0 ? 0 : errno;
   close(file);
   /* some file systems cannot do it */
   return number == EINVAL || number == ENOTSUP || number == ENOSYS ? 0 : number;
}

/* Begin to bring a file to the disk without waiting for it, where the system can do that. */
void adfric_begin_to_synchronise(const char *path)
{
#ifdef SYNC_FILE_RANGE_WRITE
   const int file = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
   if (file < 0) return;
   /* whatever goes wrong shows when the file is brought to the disk for good */
   (void)sync_file_range(file, 0, 0, SYNC_FILE_RANGE_WRITE);
   close(file);
#else
   (void)path;
#endif
}

/* Bring the names in the folder of a file to the disk. 0 or an error number. */
static int synchronise_folder_of(const char *path)
{
   char folder[PATH_MAX];
   const char *slash = strrchr(path, '/');
   const size_t n = slash == NULL ? 0 : (size_t)(slash - path) + 1;
   if (n >= sizeof folder) return ENAMETOOLONG;
   memcpy(folder, path, n);
   folder[n] = '\0';
   return adfric_synchronise(n == 0 ? "." : folder);
}

/* Rename a file; what stands at the new name is overwritten only if asked for. 0 or an error number. */
static int rename_safely(const char *from, const char *to, int overwrite)
{
   if (!overwrite) {
      if (link(from, to) == 0) return unlink(from) == 0 ? 0 : errno;
      if (errno == EEXIST) return EEXIST;
      /* A file system without hard links. */
      if (adfric_kind_of_path(to) != 0) return EEXIST;
   }
   return rename(from, to) == 0 ? 0 : errno;
}

/* Rename a file on the disk; what stands at the new name is overwritten only if asked for. 0 or an error number. */
int adfric_move_file(const char *from, const char *to, int overwrite)
{
   /* the old results go only when the new ones are safe */
   int number = adfric_synchronise(from);
   if (number == 0) number = rename_safely(from, to, overwrite);
   return number == 0 ? synchronise_folder_of(to) : number;
}

/* Rename a file, whatever stands at the new name. 0 or an error number. */
int adfric_rename_file(const char *from, const char *to)
{
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
