/* SPDX-License-Identifier: GPL-3.0-or-later */
/* adfric for C and C++ (docs/reference/library.md).

   A case is a scene, as an input describes it, or a model by its name; its variables are set by name. It is solved at any number of
   points, and what is found are results: arrays with names, units and dimensions, which are those of the results file of the same
   run, value by value.

       adfric_open_scene, adfric_read, ... ---> case ---adfric_set_..., adfric_sweep---> case ---adfric_solve---> case, and results
                                                 |                                                                          |
                                                 +---adfric_close_case                           adfric_close_results-------+

   Status. Every function but adfric_message and adfric_version gives back 0, or what went wrong; what it should have changed is
   as it was before then, and what it should have given is not touched, but for a dataset that is refused: it is not given any
   more. adfric_message says it in the words that the program has for an input. Nothing here ends the program, prints, or catches
   signals.

   Handles are numbers, 0 is none of them. One that is closed, was never given out, or is of the other kind is refused.

   Threads. Any number of threads may call at once, each with handles of its own; a handle that another thread uses at the moment
   is refused. Only adfric_stop is for others. Results that are not closed may be read by all threads.

   Texts end by a 0 and are UTF-8. What is given out as `const char *` stays as it is until the program ends, except for what
   adfric_message gives, and where it is said otherwise. No pointer may be NULL unless it is said that it may.

   Units are SI units, written as in the results file: "1" for a pure number. Places count from 0. */

#ifndef ADFRIC_H
#define ADFRIC_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What has become of a call. */
enum {
   ADFRIC_OK = 0,        /**< all went well */
   ADFRIC_BAD_INPUT = 2, /**< something that was given is wrong */
   ADFRIC_FAILED = 3,    /**< a file cannot be read, or the machine has too little memory or too few threads */
   ADFRIC_STOPPED = 4    /**< adfric_stop, or the caller's own function, has stopped the call */
};

/** What has become of a point. That it has no equilibrium or has not converged is no error of the call. */
enum {
   ADFRIC_SOLVED = 0,         /**< the state was found */
   ADFRIC_NO_EQUILIBRIUM = 1, /**< there is no such state, which is an answer; results that need one are NaN */
   ADFRIC_NOT_CONVERGED = 2,  /**< the state was not found to the tolerance; its results are NaN */
   ADFRIC_NO_MEMORY = -1,     /**< of one contact: there is too little memory for it */
   ADFRIC_BAD_ARGUMENT = -2   /**< of one contact: an argument is NaN or not allowed */
};

/** Version of the library, such as "0.2.0 (36f567f)". */
const char *adfric_version(void);

/** What was wrong with the last call of this thread; empty if nothing was. Several problems have a line each. It stays as it is
    until this thread calls another function. */
const char *adfric_message(void);

/* ---- Models ---- */

/** A model. */
typedef struct {
   const char *name;         /**< as adfric_open wants it */
   const char *summary;      /**< one line */
   const char *references;   /**< where it was published; empty if nowhere */
   const char *profile_axes; /**< names of the axes of its profiles, the slowest first, separated by a blank */
   int32_t n_variables;      /**< number of its variables */
   int32_t n_results;        /**< number of its results, with doubt, error_estimate and status */
   int32_t n_profiles;       /**< number of its profiles */
} adfric_model_info;

/** Number of models. */
int adfric_model_count(int32_t *n);

/** A model by its place. */
int adfric_model(int32_t place, adfric_model_info *model);

/** What a variable takes, and by which functions. */
enum {
   ADFRIC_REAL = 1,    /**< a number: adfric_set_real, adfric_sweep */
   ADFRIC_INTEGER = 2, /**< a whole number: adfric_set_integer, adfric_set_real, adfric_sweep */
   ADFRIC_LOGICAL = 3, /**< true or false: adfric_set_logical */
   ADFRIC_WORD = 4,    /**< one of several words: adfric_set_word */
   ADFRIC_ARRAY = 5    /**< an array: adfric_set_array */
};

/** A variable of a model. */
typedef struct {
   const char *group;        /**< its namelist group */
   const char *name;         /**< its name in the group */
   const char *unit;         /**< SI unit, of an array that of its values; empty for logicals and words */
   const char *meaning;      /**< what it is */
   const char *allowed;      /**< what it may be, such as "a number > 0 [Pa/m]" */
   const char *choices;      /**< the words that are allowed, separated by a blank; empty unless it is one of several words */
   const char *default_text; /**< its value where none is given, as in an input; empty if there is none */
   const char *columns;      /**< of columns: their names, separated by a blank; else empty */
   const char *column_units; /**< of columns: their units, separated by a blank; else empty */
   double default_value;     /**< default of a number, 0 or 1 of a logical, place of a word in choices; NaN if there is none */
   double lower, upper;      /**< least and greatest value, of an array that of each value; infinite where there is none */
   int32_t kind;             /**< ADFRIC_REAL, ... */
   int32_t lower_is_open;    /**< 1: the least value itself is not allowed */
   int32_t upper_is_open;    /**< 1: the greatest value itself is not allowed */
   int32_t largest_rank;     /**< most dimensions of an array, 1 or 2; else 0 */
   int32_t is_list;          /**< 1: an array whose numbers may stand in an input */
} adfric_variable_info;

/** A result or a profile of a model. Units that depend on the values of a case are right in its results. */
typedef struct {
   const char *name;          /**< its name */
   const char *unit;          /**< SI unit */
   const char *long_name;     /**< what it is */
   const char *flag_meanings; /**< of a result that is one of several states: their names, separated by a blank; else empty */
   int32_t first_flag;        /**< the number of the first state; the others follow it */
} adfric_result_info;

/** A variable by its model and its place. */
int adfric_variable(const char *model, int32_t place, adfric_variable_info *variable);

/** A result by its model and its place; doubt, error_estimate and status are the last ones. */
int adfric_result(const char *model, int32_t place, adfric_result_info *result);

/** A profile by its model and its place. */
int adfric_profile(const char *model, int32_t place, adfric_result_info *profile);

/* ---- Cases ---- */

/** A case; 0 is none. */
typedef int64_t adfric_case;

/** Open a case of a model. Its variables have their defaults, or no value. */
int adfric_open(const char *model, adfric_case *opened);

/** Open a case as an input describes it, with its sweeps and its datasets, or a fit with its data (adfric_read_fit). */
int adfric_read(const char *path, adfric_case *opened);

/** The same of the text of an input. Names of files in it are seen from the current folder. */
int adfric_read_text(const char *text, adfric_case *opened);

/** Open a scene as the text of an input describes it, some of whose variables get their values later: by adfric_set_array in place
    of the name of a dataset, by adfric_sweep, or by adfric_set_real and the like. The solver is chosen as if they had values, and
    adfric_check and adfric_solve check all values together.
    @param text     the input, with the groups of a scene
    @param n_names  number of variables that get their values later, >= 0
    @param names    their names, such as "surface%heights" or "load"; may be NULL where there are none */
int adfric_open_scene(const char *text, int32_t n_names, const char *const *names, adfric_case *opened);

/** A table of measured numbers that a fit takes in place of a file. */
typedef struct {
   const char *name;           /**< what the input calls it: &data file = 'NAME' */
   const char *const *columns; /**< names of its columns */
   const char *const *units;   /**< their units, such as "nN", empty for SI units; NULL: SI units throughout */
   const double *values;       /**< the numbers, those of a column side by side, NaN where there is none */
   int64_t n;                  /**< number of rows, > 0 */
   int32_t n_columns;          /**< number of columns, > 0 */
} adfric_table;

/** Open a fit as the text of an input of `adfric fit` describes it. It is a case whose values are those of its input, and that is
    solved once. Its points are curves; a single fit has arrays of ADFRIC_EXTRA beside its results.
    @param text      the input
    @param n_tables  number of tables, >= 0
    @param tables    the tables, which are copied; NULL where there are none. Another name in the input is that of a file */
int adfric_read_fit(const char *text, int32_t n_tables, const adfric_table *tables, adfric_case *opened);

/** Close a case. Its results stay as they are. */
int adfric_close_case(adfric_case self);

/** Set a variable that is a number. It is not swept any more.
    @param name   name of the variable, or "group%name" where several groups have one
    @param value  value in the SI unit of the variable */
int adfric_set_real(adfric_case self, const char *name, double value);

/** Set a variable that is a whole number. */
int adfric_set_integer(adfric_case self, const char *name, int64_t value);

/** Set a variable that is true or false.
    @param value  0: false; else true */
int adfric_set_logical(adfric_case self, const char *name, int value);

/** Set a variable that is one of several words. */
int adfric_set_word(adfric_case self, const char *name, const char *value);

/** Set a variable that is an array, in place of the name of a dataset or of a list. The values are copied.
    @param rank    number of dimensions, 1 or 2
    @param shape   number of values along each; a map has the shape {ny, nx}, columns have {n_columns, n}
    @param values  the values in SI units, the last dimension varies fastest */
int adfric_set_array(adfric_case self, const char *name, int32_t rank, const int64_t *shape, const double *values);

/** Give a variable its default again, or no value. It is not swept any more. */
int adfric_unset(adfric_case self, const char *name);

/** Sweep a variable. Several sweeps make the outer product of their values; the variable that is swept last varies fastest. One
    that is swept already takes the new values in the same place.
    @param n       number of values, > 0
    @param values  values in the SI unit of the variable, in any order; they are copied */
int adfric_sweep(adfric_case self, const char *name, int64_t n, const double *values);

/** Sweep several variables together: a list of points.
    @param n_names  number of variables, > 0
    @param names    their names
    @param n        number of values of each, > 0
    @param values   values in SI units, those of a variable side by side; shape {n_names, n}; they are copied */
int adfric_sweep_together(adfric_case self, int32_t n_names, const char *const *names, int64_t n, const double *values);

/** Name of the model of a case. */
int adfric_model_of(adfric_case self, const char **model);

/** The scene of a case in words, where its input describes one; empty for a case of a model. */
int adfric_scene_of(adfric_case self, const char **scene);

/** A variable of a case by its name, or "group%name" where several groups have one; that of a scene has the name and the group that
    scenes have. */
int adfric_variable_of(adfric_case self, const char *name, adfric_variable_info *variable);

/** A variable, a result, a profile or an axis of the profiles of a case by its name. Where the unit depends on values, it is that
    of the case if they are complete, else that of the table. */
int adfric_describe(adfric_case self, const char *name, adfric_result_info *described);

/** Number of points of a case; 1 where nothing is swept. */
int adfric_point_count(adfric_case self, int64_t *n);

/** Check all values together, as adfric_solve does before it solves; what is wrong is said with a line each. */
int adfric_check(adfric_case self);

/** Results; 0 is none. */
typedef int64_t adfric_results;

/** A function of the caller that is told from time to time how far a call is. It is called by the thread that has called
    adfric_solve, and must come back.
    @param context   what was given to adfric_solve
    @param n_done    number of points that are solved
    @param n_points  number of all points
    @return 0, or anything else to stop */
typedef int (*adfric_progress)(void *context, int64_t n_done, int64_t n_points);

/** Solve all points. They are solved in the blocks of the program, so that results are those of its file, to the bit.
    @param n_threads  number of threads; 0: as many as OpenMP gives. The results do not depend on it.
    @param progress   is told how far the call is; may be NULL
    @param context    for progress; may be NULL
    @param found      receives the results, which are to be closed */
int adfric_solve(adfric_case self, int32_t n_threads, adfric_progress progress, void *context, adfric_results *found);

/** Solve a case of one point, and give some of its results as numbers alone: for loops, where adfric_results would take longer than
    the point.
    @param n_names  number of results
    @param names    their names, among them "status" and "error_estimate"; of a result that is one of several states the number of
                    the state is given
    @param values   receives them, NaN where there is no value */
int adfric_solve_point(adfric_case self, int32_t n_names, const char *const *names, double *values);

/** Stop the call of adfric_solve that another thread makes with this case at the moment; it gives back ADFRIC_STOPPED as soon as
    the points that are being solved are done, or the iterations of points that take long. Where there is none, nothing happens. A handler of signals may call it: it waits
    for nothing, and leaves adfric_message as it is. */
int adfric_stop(adfric_case self);

/* ---- Results ---- */

/** What an array of results is. */
enum {
   ADFRIC_COORDINATE = 1, /**< values of a swept variable, of an axis of profiles, or the places in a list */
   ADFRIC_RESULT = 2,     /**< a result at every point */
   ADFRIC_PROFILE = 3,    /**< a profile at every point */
   ADFRIC_PARAMETER = 4,  /**< a variable that is not swept, or what follows from such ones: one value */
   ADFRIC_LIST = 5,       /**< a variable that is a list of numbers */
   ADFRIC_EXTRA = 6,      /**< what a fit has beside its results: intervals, minima, residuals, curves */
   ADFRIC_WORDS = 7       /**< words along a dimension of these: states whose meanings are the words */
};

/** An array of results. All that it points to belongs to the results and is there until they are closed. */
typedef struct {
   const char *name;              /**< as in the results file */
   const char *unit;              /**< SI unit, "1" for a pure number */
   const char *long_name;         /**< what it is */
   const char *flag_meanings;     /**< names of the states, separated by a blank; empty for numbers */
   const char *const *dimensions; /**< names of the dimensions, the slowest first; a coordinate may have that name */
   const int64_t *shape;          /**< number of values along each dimension */
   const int64_t *strides;        /**< how many values stand from one to the next along each dimension */
   const double *values;          /**< the numbers, NaN where there is none; NULL for states */
   const int8_t *states;          /**< the numbers of the states; NULL for numbers */
   int32_t rank;                  /**< number of dimensions; 0 for one value */
   int32_t first_flag;            /**< number of the first state; the others follow it */
   int32_t role;                  /**< ADFRIC_COORDINATE, ... */
} adfric_array;

/** Something that is said of the results as a whole, as an attribute of the results file. */
typedef struct {
   const char *name; /**< its name */
   const char *text; /**< its text, there until the results are closed; NULL if it is a number */
   double number;    /**< the number; NaN if it is a text */
} adfric_attribute_info;

/** Number of arrays. */
int adfric_array_count(adfric_results self, int32_t *n);

/** An array by its place, in the order of the results file. Nothing is copied. */
int adfric_array_at(adfric_results self, int32_t place, adfric_array *array);

/** An array by its name. Nothing is copied. */
int adfric_array_of(adfric_results self, const char *name, adfric_array *array);

/** Number of attributes. */
int adfric_attribute_count(adfric_results self, int32_t *n);

/** An attribute by its place. */
int adfric_attribute(adfric_results self, int32_t place, adfric_attribute_info *attribute);

/** Close results and give back their memory. */
int adfric_close_results(adfric_results self);

/* ---- One contact: batches ----

   What follows solves n contacts, one for each value of its arrays, in reduced variables. It keeps nothing between calls, and
   starts no threads. Each array has n values; what is received must not overlap with anything else. `status` receives
   ADFRIC_SOLVED, ... or ADFRIC_BAD_ARGUMENT for each contact; all else that is received is NaN where it is not ADFRIC_SOLVED.
   Arrays of flags may be NULL, if none of them is set. */

/** Units of the reduced variables of a sphere (Johnson 1997, eq. 2.11). All that is given must be > 0.
    @param radius            radius R of the sphere [m]
    @param contact_modulus   contact modulus E* [Pa]
    @param work_of_adhesion  work of adhesion w [J/m^2]
    @param length            receives the unit of radii in the plane of contact [m]
    @param closer            receives the unit of the approach [m]
    @param force             receives the unit of loads [N]
    @param strength          receives the unit of stresses [Pa]: the adhesion stress in it is Maugis's lambda */
int adfric_sphere_scales(int64_t n, const double *radius, const double *contact_modulus, const double *work_of_adhesion,
                        double *length, double *closer, double *force, double *strength);

/** Adhesive sphere by Maugis's theory with Dugdale's law, under a load.
    @param lambda           Maugis's parameter, 1e-30 to 1e30
    @param load             load; tension is negative
    @param is_unstable      not 0: of two states the one that is not stable; may be NULL
    @param contact_radius   receives the radius a of intimate contact
    @param adhesion_radius  receives the radius c up to which adhesion acts
    @param approach         receives the approach
    @param status           receives what has become of the contact */
int adfric_sphere_load(int64_t n, const double *lambda, const double *load, const int8_t *is_unstable, double *contact_radius,
                       double *adhesion_radius, double *approach, int32_t *status);

/** The same at an approach; separation is negative. A contact_radius of 0: the surfaces only attract each other. */
int adfric_sphere_approach(int64_t n, const double *lambda, const double *approach, const int8_t *is_unstable,
                           double *contact_radius, double *adhesion_radius, double *load, int32_t *status);

/** The same for a radius of intimate contact, >= 0. */
int adfric_sphere_radius(int64_t n, const double *lambda, const double *contact_radius, double *adhesion_radius, double *load,
                         double *approach, int32_t *status);

/** Where a contact that is pulled ends: the least load, or the least approach, that has a stable contact.
    @param holds_approach  not 0: the approach is held, and not the load; may be NULL */
int adfric_sphere_pull_off(int64_t n, const double *lambda, const int8_t *holds_approach, double *load, double *approach,
                           double *contact_radius, int32_t *status);

/** Rigid wavy strip that slides on a viscoelastic foundation and adheres to it (Goryacheva, Makhovskaya 2011), under a load.
    Lengths along the surface are in periods l, heights and penetrations in the height h of the wave, stresses in h times the
    stiffness of the foundation, friction in that times h/l.
    @param phase             relaxation phase 2 pi V Ts/l, 0 to 1e30: the speed
    @param ratio             ratio Te/Ts of retardation and relaxation time, 1 to 1e30
    @param stress            adhesion stress, 0 to 1e30; 0: no adhesion
    @param range             range of adhesion, > 0; not used without adhesion
    @param load              load; tension is negative
    @param is_instantaneous  not 0: the displacement jumps where adhesion begins and ends; may be NULL
    @param is_approach       not 0: the branch where loading arrives, and not that of unloading; may be NULL
    @param penetration       receives the penetration of the crest
    @param friction          receives the friction force
    @param width             receives the width of the contact
    @param shift             receives the shift of the middle of the contact from the crest
    @param status            receives what has become of the state */
int adfric_strip_load(int64_t n, const double *phase, const double *ratio, const double *stress, const double *range,
                      const double *load, const int8_t *is_instantaneous, const int8_t *is_approach, double *penetration,
                      double *friction, double *width, double *shift, int32_t *status);

/** The same at a penetration; receives the load. */
int adfric_strip_penetration(int64_t n, const double *phase, const double *ratio, const double *stress, const double *range,
                             const double *penetration, const int8_t *is_instantaneous, const int8_t *is_approach, double *load,
                             double *friction, double *width, double *shift, int32_t *status);

/** One periodic rough surface on an elastic half-space, without adhesion and friction, under a mean pressure. Lengths are in any
    unit, pressures in the contact modulus E*. Numbers of cells with many factors of 2 are solved fastest.
    @param ny, nx            number of cells along y and x, >= 4; ny = 1 for a surface that does not vary along y
    @param heights           heights of the rough body, the largest touches first; shape {ny, nx}, x varies fastest
    @param period_y, period_x  periods, > 0; that in y is not used where ny is 1
    @param mean_pressure     mean pressure
    @param tolerance         largest violation of the conditions of contact, 1e-13 to 1e-3, such as 1e-10
    @param pressure          receives the pressure; shape of heights
    @param gap               receives the gap; shape of heights
    @param penetration       receives how far the surfaces approached from first touch
    @param contact_fraction  receives the share of the surface in contact
    @param status            receives what has become of the contact; ADFRIC_NO_MEMORY, too */
int adfric_periodic_pressure(int64_t ny, int64_t nx, const double *heights, double period_y, double period_x, double mean_pressure,
                             double tolerance, double *pressure, double *gap, double *penetration, double *contact_fraction,
                             int32_t *status);

/** The same at a penetration; receives the mean pressure. */
int adfric_periodic_penetration(int64_t ny, int64_t nx, const double *heights, double period_y, double period_x,
                                double penetration, double tolerance, double *pressure, double *gap, double *mean_pressure,
                                double *contact_fraction, int32_t *status);

#ifdef __cplusplus
}
#endif

#endif
