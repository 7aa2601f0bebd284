/* SPDX-License-Identifier: MIT */
/**
 * @file  truckride/modelfile.h
 * @brief Vehicles as JSON files: read, check and write specs.
 *
 * A model file says everything a spec can, in SI units; docs/model-files.md is its guide and
 * docs/truckride-model.schema.json its schema. Beside the parts of a spec it knows axles, mirrored parts,
 * ladder frames and tables from CSV files, which become parts when it is read. What
 * trk_model_file_write() writes are the parts themselves; reading them back gives the same spec, to the bit.
 *
 * Every complaint begins with "file:line:column: ". Needs TRK_FEATURE_JSON to read.
 */
#ifndef TRUCKRIDE_MODELFILE_H
#define TRUCKRIDE_MODELFILE_H

#include <truckride/frame.h>

/**
 * Read a vehicle from a file.
 *
 * @param path     of the file; tables it names are looked for in its folder
 * @param out_spec owned by caller; NULL on failure
 * @retval TRK_E_ARGUMENT    a pointer is NULL
 * @retval TRK_E_FILE        the file, or a table it names, cannot be read
 * @retval TRK_E_SYNTAX      not JSON, or not what the schema says: a key that is unknown (the message
 *                           suggests one), missing or there twice, or a value of another kind
 * @retval TRK_E_RANGE, TRK_E_NAME, TRK_E_MODEL  a value, a name or the vehicle as in spec.h
 * @retval TRK_E_UNSUPPORTED this build has no jansson, or the file is of a later version
 * @retval TRK_E_MEMORY      no memory
 */
TRK_API trk_status trk_model_file_read(trk_context *context, const char *path,
                                       trk_spec **out_spec) TRK_MUST_CHECK;

/**
 * The same from text in memory.
 *
 * @param text   JSON in UTF-8, need not end with a zero
 * @param length [byte] of the text
 * @param source how messages call it, "truck.json"
 * @param folder where tables are looked for; NULL: tables in files are refused
 */
TRK_API trk_status trk_model_file_parse(trk_context *context, const char *text, size_t length,
                                        const char *source, const char *folder,
                                        trk_spec **out_spec) TRK_MUST_CHECK;

/**
 * Write a spec as JSON text. Says what is wrong by its status alone, without a message.
 *
 * @param capacity   [byte] room in out_text, with the closing zero
 * @param out_text   receives at most capacity bytes, always closed by a zero if capacity > 0; NULL
 *                   with capacity 0 to ask for the length
 * @param out_length [byte] length of the whole text without the zero; NULL to skip
 * @retval TRK_E_ARGUMENT a pointer is NULL
 * @retval TRK_E_RANGE    the text does not fit: out_length says what is needed
 * @retval TRK_E_NAME     a name is not UTF-8, which JSON must be
 */
TRK_API trk_status trk_model_file_format(const trk_spec *spec, size_t capacity, char *out_text,
                                         size_t *out_length) TRK_MUST_CHECK;

/**
 * Write a spec to a file, which is replaced only when all is written.
 * @retval TRK_E_ARGUMENT a pointer is NULL
 * @retval TRK_E_NAME     a name is not UTF-8
 * @retval TRK_E_FILE     the file cannot be written
 * @retval TRK_E_MEMORY   no memory
 */
TRK_API trk_status trk_model_file_write(trk_context *context, const trk_spec *spec,
                                        const char *path) TRK_MUST_CHECK;

#endif
