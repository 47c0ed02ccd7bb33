/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the C interface keeps between calls: which handles are open, the last message of each thread, texts that are given out, and
   the tables of the models. */

#define _GNU_SOURCE

#include <pthread.h>
#include <stdatomic.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* ---- Handles ---- */

/* A handle is the number of its slot, that of its turn in the slot, from 1, and its kind. */
enum { kind_bits = 1, slot_bits = 22, slots_of_chunk = 1024, most_chunks = (1 << slot_bits)/slots_of_chunk };

/* Kinds of handles. */
enum { kind_case = 0, kind_results = 1 };

/* What a handle is good for. */
enum { handle_good = 0, handle_unknown = 1, handle_closed = 2, handle_of_other_kind = 3, handle_in_use = 4 };

struct slot {
   _Atomic(int64_t) handle;   /* the open handle; 0 if there is none */
   int64_t turn;              /* how many handles the slot has had */
   void *object;
   int n_users;               /* threads that use it; -1: one that uses it alone */
   int next_free;             /* number of the next free slot, -1 if there is none */
   atomic_int is_stoppable, is_stopping;
   int64_t outer;             /* what the thread works on that has called for this work, beside it */
};

/* Chunks stay where they are and are never given back, so that a handler of signals may look at them. */
static _Atomic(struct slot *) chunks[most_chunks];
static pthread_mutex_t lock_of_slots = PTHREAD_MUTEX_INITIALIZER;
static int n_slots = 0, first_free = -1;

/* A slot by its number; NULL if there is none. */
static struct slot *slot_at(int number)
{
   struct slot *chunk = atomic_load(&chunks[number/slots_of_chunk]);
   return chunk == NULL ? NULL : &chunk[number%slots_of_chunk];
}

static int number_of(int64_t handle)
{
   return (int)(handle >> kind_bits & ((1 << slot_bits) - 1));
}

/* A free slot, taken out of the list; -1 if there is no memory for one. */
static int take_free_slot(void)
{
   int number = first_free;
   if (number >= 0) {
      first_free = slot_at(number)->next_free;
      return number;
   }
   if (n_slots == most_chunks*slots_of_chunk) return -1;
   if (n_slots%slots_of_chunk == 0) {
      struct slot *chunk = calloc(slots_of_chunk, sizeof *chunk);
      if (chunk == NULL) return -1;
      atomic_store(&chunks[n_slots/slots_of_chunk], chunk);
   }
   return n_slots++;
}

/* A new handle of an object; 0 if there is no memory for it. */
int64_t adfric_new_handle(int kind, void *object)
{
   int64_t handle = 0;
   pthread_mutex_lock(&lock_of_slots);
   const int number = take_free_slot();
   if (number >= 0) {
      struct slot *slot = slot_at(number);
      slot->turn++;
      slot->object = object;
      slot->n_users = 0;
      handle = (slot->turn << slot_bits | number) << kind_bits | kind;
      atomic_store(&slot->handle, handle);
   }
   pthread_mutex_unlock(&lock_of_slots);
   return handle;
}

/* What a handle is good for, with its slot if it is open. */
static int look_up(int64_t handle, int kind, struct slot **slot)
{
   if (handle <= 0) return handle_unknown;
   *slot = slot_at(number_of(handle));
   const int64_t turn = handle >> (kind_bits + slot_bits);
   if (*slot == NULL || turn < 1 || turn > (*slot)->turn) return handle_unknown;
   if ((handle & ((1 << kind_bits) - 1)) != kind) return handle_of_other_kind;
   return atomic_load(&(*slot)->handle) == handle ? handle_good : handle_closed;
}

/* Begin to use an object, alone or together with others. */
int adfric_take_object(int64_t handle, int kind, int is_alone, void **object)
{
   struct slot *slot = NULL;
   *object = NULL;
   pthread_mutex_lock(&lock_of_slots);
   int what = look_up(handle, kind, &slot);
   if (what == handle_good && (slot->n_users < 0 || (is_alone && slot->n_users > 0))) what = handle_in_use;
   if (what == handle_good) {
      slot->n_users = is_alone ? -1 : slot->n_users + 1;
      *object = slot->object;
   }
   pthread_mutex_unlock(&lock_of_slots);
   return what;
}

/* End the use of an object that was taken. */
void adfric_leave_object(int64_t handle)
{
   pthread_mutex_lock(&lock_of_slots);
   struct slot *slot = slot_at(number_of(handle));
   slot->n_users = slot->n_users < 0 ? 0 : slot->n_users - 1;
   pthread_mutex_unlock(&lock_of_slots);
}

/* Close the handle of an object that was taken alone. */
void adfric_end_handle(int64_t handle)
{
   pthread_mutex_lock(&lock_of_slots);
   const int number = number_of(handle);
   struct slot *slot = slot_at(number);
   atomic_store(&slot->handle, 0);
   slot->object = NULL;
   slot->n_users = 0;
   slot->next_free = first_free;
   first_free = number;
   pthread_mutex_unlock(&lock_of_slots);
}

/* ---- Stopping ---- */

/* What this thread has called for, and when it may look up from it again. */
static _Thread_local int64_t called_for = 0;
static _Thread_local struct timespec due_at;

/* Time between two looks [ns]. */
enum { nanoseconds_of_look = 50000000, nanoseconds_of_second = 1000000000 };

/* From now on, or no longer, the work on an object that was taken can be stopped. */
void adfric_let_stop(int64_t handle, int may)
{
   struct slot *slot = slot_at(number_of(handle));
   atomic_store(&slot->is_stopping, 0);
   atomic_store(&slot->is_stoppable, may);
   if (may) slot->outer = called_for;
   called_for = may ? handle : slot->outer;
}

/* Is it this thread that has called for the work on an object, and is it time for it to look up? A coarse clock takes next to no
   time. */
int adfric_is_due(int64_t handle)
{
   struct timespec now;
   if (called_for != handle) return 0;
   if (clock_gettime(CLOCK_MONOTONIC_COARSE, &now) != 0) return 0;
   if (now.tv_sec < due_at.tv_sec || (now.tv_sec == due_at.tv_sec && now.tv_nsec < due_at.tv_nsec)) return 0;
   due_at = now;
   due_at.tv_nsec += nanoseconds_of_look;
   if (due_at.tv_nsec >= nanoseconds_of_second) {
      due_at.tv_sec++;
      due_at.tv_nsec -= nanoseconds_of_second;
   }
   return 1;
}

/* Shall the work on an object that was taken stop? */
int adfric_shall_stop(int64_t handle)
{
   return atomic_load(&slot_at(number_of(handle))->is_stopping);
}

/* See adfric.h. It takes no lock, since a handler of signals may call it. */
int adfric_stop(int64_t handle)
{
   const int is_case = (handle & ((1 << kind_bits) - 1)) == kind_case;
   struct slot *slot = handle > 0 && is_case ? slot_at(number_of(handle)) : NULL;
   if (slot == NULL || atomic_load(&slot->handle) != handle) return 2;
   if (atomic_load(&slot->is_stoppable)) atomic_store(&slot->is_stopping, 1);
   return 0;
}

/* ---- Messages ---- */

static _Thread_local char *message = NULL;
static _Thread_local size_t room_of_message = 0;
static _Thread_local const char *shown = "";
static pthread_once_t once = PTHREAD_ONCE_INIT;
static pthread_key_t key;
static int has_key = 0;

/* A thread ends. */
static void drop_message(void *text)
{
   free(text);
   message = NULL;
   room_of_message = 0;
   shown = "";
}

static void make_key(void)
{
   has_key = pthread_key_create(&key, drop_message) == 0;
}

/* Keep a message for this thread, until its end. */
void adfric_keep_message(const char *text, size_t length)
{
   shown = "";
   if (length == 0) return;
   if (length + 1 > room_of_message) {
      pthread_once(&once, make_key);
      char *larger = has_key ? realloc(message, length + 1) : NULL;
      if (larger == NULL) {
         shown = "there is too little memory to say what is wrong";
         return;
      }
      message = larger;
      room_of_message = length + 1;
      pthread_setspecific(key, message);
   }
   memcpy(message, text, length);
   message[length] = '\0';
   shown = message;
}

/* See adfric.h. */
const char *adfric_message(void)
{
   return shown;
}

/* ---- Texts that are given out ---- */

struct kept_text {
   struct kept_text *next;
   size_t length;
   char text[];
};

enum { n_lists = 1024 };
static struct kept_text *kept_texts[n_lists];
static pthread_mutex_t lock_of_texts = PTHREAD_MUTEX_INITIALIZER;

/* The same text, which stays until the program ends; NULL if there is no memory for it. */
const char *adfric_keep_text(const char *text, size_t length)
{
   size_t hash = 5381;
   for (size_t i = 0; i < length; i++) hash = 33*hash ^ (unsigned char)text[i];
   struct kept_text **list = &kept_texts[hash%n_lists];
   pthread_mutex_lock(&lock_of_texts);
   struct kept_text *kept = *list;
   while (kept != NULL && (kept->length != length || memcmp(kept->text, text, length) != 0)) kept = kept->next;
   if (kept == NULL) {
      kept = malloc(sizeof *kept + length + 1);
      if (kept != NULL) {
         memcpy(kept->text, text, length);
         kept->text[length] = '\0';
         kept->length = length;
         kept->next = *list;
         *list = kept;
      }
   }
   pthread_mutex_unlock(&lock_of_texts);
   return kept == NULL ? NULL : kept->text;
}

/* ---- Tables ---- */

enum { most_models = 64 };
static void *tables[most_models];

/* The place where the tables of a model are kept; NULL is there before they are made. One thread at a time. */
void **adfric_tables_at(int place)
{
   return place < 0 || place >= most_models ? NULL : &tables[place];
}
