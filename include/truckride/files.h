/* SPDX-License-Identifier: MIT */
/**
 * @file  truckride/files.h
 * @brief Measured data in, results out: CSV, ERD, MTS RPC III, MATLAB level 5.
 *
 * Each reader exists twice: trk_..._read_...() takes the path of a file, trk_..._parse_...() its
 * bytes, from wherever they come, and a name for the messages. Nothing in the bytes is trusted:
 * no reader takes more memory than a small multiple of their number, whatever counts a header
 * states. Numbers have a decimal point in every locale and come back exactly if they were written
 * with 17 digits (BASE.1). What is wrong is said with its place: "road.csv:12:7: ...", line and
 * column in bytes, from 1; in binary parts the byte, from 0.
 *
 * A profile over distance is a series, too: its sample rate is in 1/m and its start in m.
 *
 * OpenCRG surfaces have a header of their own, truckride/crg.h.
 */
#ifndef TRUCKRIDE_FILES_H
#define TRUCKRIDE_FILES_H

#include <truckride/series.h>
#include <truckride/signal.h>

/** Options of the CSV readers. */
typedef struct trk_csv_options {
    size_t  struct_size;       /**< [byte] set by trk_csv_options_init()                         */
    int32_t separator;         /**< [-] comma, semicolon, tab or ' ' (any number of blanks and tabs);
                                    default 0: found from the first lines                        */
    int32_t decimal_comma;     /**< [-] 1: numbers have a decimal comma; the separator must then be
                                    a semicolon. Default 0: a point                                      */
    double  spacing_tolerance; /**< [-] how far a place on the axis may lie off the even grid from
                                    the first to the last, in grid steps, 0 to 0.5; default 0.01 */
} trk_csv_options;

/** Set every field to its default. Call as trk_csv_options_init(&o, sizeof o). */
TRK_API void trk_csv_options_init(trk_csv_options *options, size_t struct_size);

/**
 * Read a table as a series (FILES.1). The first column is the axis, time or distance, and must be
 * evenly spaced; the others become channels.
 *
 * The first row may hold names, "name [unit]" or "name (unit)", and the one behind it units.
 * Fields may be quoted (RFC 4180). Empty lines and lines that begin with # are skipped, as is a
 * byte order mark; lines end with LF or CR LF. An axis in ms, min, mm, cm, km, in, ft or mi is
 * converted to s or m; channels keep their units: see trk_series_to_si(). A name that occurs
 * again gets its column's number appended, "x (3)"; an empty one is "column 3".
 *
 * @param path       file to read
 * @param options    NULL for the defaults
 * @param out_series owned by caller; NULL on failure
 * @retval TRK_E_ARGUMENT a pointer is NULL
 * @retval TRK_E_OPTIONS  options come from a newer header and set an unknown field
 * @retval TRK_E_RANGE    an option is out of range, or the axis is not evenly spaced
 * @retval TRK_E_FILE     the file cannot be read
 * @retval TRK_E_SYNTAX   not such a table: a field is no finite number, a row has another number of
 *                        fields, there are fewer than two rows or columns, or a decimal comma that
 *                        the options do not announce
 * @retval TRK_E_MEMORY   no memory
 */
TRK_API trk_status trk_series_read_csv(trk_context *context, const char *path,
                                       const trk_csv_options *options,
                                       trk_series **out_series) TRK_MUST_CHECK;

/**
 * The same from memory.
 *
 * @param name  stands in messages for the path
 * @param bytes length size; may be NULL if size is 0
 * Further parameters and errors as trk_series_read_csv().
 */
TRK_API trk_status trk_series_parse_csv(trk_context *context, const char *name, const void *bytes,
                                        size_t size, const trk_csv_options *options,
                                        trk_series **out_series) TRK_MUST_CHECK;

/**
 * Read one column of a table as a signal over the first, which need not be evenly spaced but must
 * increase: trk_signal_create_points() (CURVE.3). The column is converted to SI if its unit is one
 * that trk_series_to_si() knows.
 *
 * @param column     1 is the first behind the axis
 * @param out_signal owned by caller; NULL on failure
 * @retval TRK_E_RANGE an option or column is out of range, or the axis does not increase
 * Further parameters and errors as trk_series_read_csv().
 */
TRK_API trk_status trk_signal_read_csv(trk_context *context, const char *path,
                                       const trk_csv_options *options, int32_t column,
                                       trk_signal **out_signal) TRK_MUST_CHECK;

/** The same from memory; see trk_series_parse_csv(). */
TRK_API trk_status trk_signal_parse_csv(trk_context *context, const char *name, const void *bytes,
                                        size_t size, const trk_csv_options *options, int32_t column,
                                        trk_signal **out_signal) TRK_MUST_CHECK;

/**
 * Read an ERD file (FILES.2), the road profile format of UMTRI and ProVAL: a line that begins with
 * ERDFILEV, one of counts, keywords, END, data. Data are text (key 5), or interleaved samples of
 * int16 (key 0) or float32 (key 1), little-endian, right behind the END line; that layout of the
 * binary keys was not checked against files of other programs.
 *
 * Channels in mm, cm, in, ft, ... become m, as does the distance (XUNITS).
 *
 * @retval TRK_E_UNSUPPORTED another data key
 * @retval TRK_E_SYNTAX      the header is malformed, a number too, or data are missing
 * Further parameters and errors as trk_series_read_csv(), without options.
 * Source: M. W. Sayers, S. M. Karamihas, The ERD file format for storage and analysis of road
 * profiles, UMTRI.
 */
TRK_API trk_status trk_series_read_erd(trk_context *context, const char *path,
                                       trk_series **out_series) TRK_MUST_CHECK;

/** The same from memory; see trk_series_parse_csv(). */
TRK_API trk_status trk_series_parse_erd(trk_context *context, const char *name, const void *bytes,
                                        size_t size, trk_series **out_series) TRK_MUST_CHECK;

/**
 * Read an MTS RPC III time history (FILES.3): drive and response files of test rigs, little- or
 * big-endian, SHORT_INTEGER or FLOATING_POINT. Where DATA_TYPE is missing, the size of the file
 * tells which. Integers are multiplied with SCALE.CHAN_n. Names and units are DESC.CHAN_n and
 * UNITS.CHAN_n; see trk_series_to_si().
 *
 * The format has no number of samples but of frames: the end is padding, except in files of
 * trk_series_write_rpc(). A rate that 1 / DELTA_T gives to 1e-6 as a whole number is that number.
 *
 * @retval TRK_E_UNSUPPORTED FORMAT is ASCII, or FILE_TYPE is not TIME_HISTORY
 * @retval TRK_E_SYNTAX      a key is missing or out of range, the size of the data does not fit the
 *                           header, or a value is not finite
 * Further parameters and errors as trk_series_read_csv(), without options.
 * Source: MTS Systems, RPC III file formats.
 */
TRK_API trk_status trk_series_read_rpc(trk_context *context, const char *path,
                                       trk_series **out_series) TRK_MUST_CHECK;

/** The same from memory; see trk_series_parse_csv(). */
TRK_API trk_status trk_series_parse_rpc(trk_context *context, const char *name, const void *bytes,
                                        size_t size, trk_series **out_series) TRK_MUST_CHECK;

/** How RPC III files hold samples. */
typedef int32_t trk_rpc_type;
enum {
    TRK_RPC_FLOATING_POINT = 0, /**< float32: 7 digits                                     */
    TRK_RPC_SHORT_INTEGER  = 1  /**< int16 of the channel's peak: half a step is peak/65504 */
};

/** Options of trk_series_write_rpc(). */
typedef struct trk_rpc_options {
    size_t       struct_size; /**< [byte] set by trk_rpc_options_init()                       */
    trk_rpc_type type;        /**< [-] default TRK_RPC_FLOATING_POINT                         */
    int32_t      big_endian;  /**< [-] 1: BINARY_IEEE_BIG_END; default 0: little              */
    int32_t      drive;       /**< [-] 1: TIME_TYPE is DRIVE; default 0: RESPONSE             */
    int32_t      reserved;    /**< [-] must be 0                                              */
} trk_rpc_options;

/** Set every field to its default. Call as trk_rpc_options_init(&o, sizeof o). */
TRK_API void trk_rpc_options_init(trk_rpc_options *options, size_t struct_size);

/**
 * Write as MTS RPC III (FILES.3): frames of 1024, groups of 2048 samples, the last one filled up
 * with the last value so that a rig does not jump. The key TRUCKRIDE_SAMPLES keeps the number of
 * samples for trk_series_read_rpc(); the start time is not kept.
 *
 * @param path    file to write; an existing one is replaced
 * @param options NULL for the defaults
 * @retval TRK_E_ARGUMENT a pointer is NULL
 * @retval TRK_E_OPTIONS  options come from a newer header and set an unknown field
 * @retval TRK_E_RANGE    an option is out of range, there are more than 128 channels, or a sample is
 *                        not finite or not in the range of float32
 * @retval TRK_E_FILE     the file cannot be written; what was written is removed
 * @retval TRK_E_MEMORY   no memory
 */
TRK_API trk_status trk_series_write_rpc(trk_context *context, const trk_series *series,
                                        const char *path,
                                        const trk_rpc_options *options) TRK_MUST_CHECK;

/**
 * Write as MATLAB level 5 (FILES.4), uncompressed, which MATLAB, Octave and SciPy load: a column
 * vector of double for each channel, named as the channel with what MATLAB does not allow replaced
 * by _ and made unique, the column vector `time` [s], and the cell arrays `channel_names` and
 * `channel_units` with the names and units as they are.
 *
 * @param path file to write; an existing one is replaced
 * @retval TRK_E_ARGUMENT a pointer is NULL
 * @retval TRK_E_RANGE    a channel is longer than the 2 GiB that a variable may have
 * @retval TRK_E_FILE     the file cannot be written; what was written is removed
 * @retval TRK_E_MEMORY   no memory
 * Source: MathWorks, MAT-file level 5 file format.
 */
TRK_API trk_status trk_series_write_mat(trk_context *context, const trk_series *series,
                                        const char *path) TRK_MUST_CHECK;

/**
 * Convert the channels whose unit is known to SI and relabel them (FILES.5): um mm cm km in inch ft
 * mi to m, ms min h to s, mm/s cm/s km/h mph to m/s, g mm/s^2 (or mm/s2) to m/s^2, kN lbf to N, deg
 * to rad, kNm to N m. Other channels stay as they are.
 *
 * @retval TRK_E_ARGUMENT series is NULL
 * @retval TRK_E_MEMORY   no memory; some channels may be converted, each with its unit
 */
TRK_API trk_status trk_series_to_si(trk_series *series) TRK_MUST_CHECK;

#endif
