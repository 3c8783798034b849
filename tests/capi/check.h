/* What the C tests check with: a line on stderr for each check that fails, and their number at the end. */
#ifndef HONEYCOMB_TESTS_CAPI_CHECK_H
#define HONEYCOMB_TESTS_CAPI_CHECK_H

#include <stdio.h>
#include <string.h>

#include "honeycomb.h"

extern int failures;

#define CHECK(condition) \
  ((condition) ? (void)0 : (void)(++failures, fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #condition)))

/* A call that must succeed. */
#define OK(call) check_status((call), HC_OK, "", __FILE__, __LINE__, #call)
/* A call that must fail so, with a message in which `words` stand. */
#define FAILS(call, status, words) check_status((call), (status), (words), __FILE__, __LINE__, #call)

static inline void check_status(hc_status status, hc_status wanted, const char* words, const char* file, int line,
                                const char* call) {
  if (status == wanted && (status == HC_OK || strstr(hc_last_message(), words) != NULL)) return;
  ++failures;
  fprintf(stderr, "%s:%d: %s gave %s: %s\n", file, line, call, hc_status_name(status), hc_last_message());
  fprintf(stderr, "    wanted: %s, with \"%s\"\n", hc_status_name(wanted), words);
}

#define COUNT(array) (sizeof(array) / sizeof((array)[0]))

#endif
