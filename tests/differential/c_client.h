#ifndef CERTET_TESTS_C_CLIENT_H
#define CERTET_TESTS_C_CLIENT_H

#ifdef __cplusplus
extern "C" {
#endif

/** A program in C that uses every function of the bridge's C header.  Returns
 * null, or what was wrong. */
const char* use_the_c_header(void);

#ifdef __cplusplus
}
#endif

#endif
