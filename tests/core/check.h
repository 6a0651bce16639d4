/* A test is a function; it fails when any of its checks does. A program ends with the line "N passed, N failed". */
#ifndef CHECK_H
#define CHECK_H

#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>

/* Trials of a law: a sixteenth under the sanitizers, which look at the same lines; make test SANITIZED_SHARE=1 has all. */
#ifdef SANITIZED
enum { SHARE = SANITIZED };
#else
enum { SHARE = 1 };
#endif
#define TIMES(count) (((count) + SHARE - 1) / SHARE)

static int tests_passed, tests_failed;
static int checks_failed_in_test;

/* Prints the first failures of a test with enough to replay them. */
__attribute__((format(printf, 4, 5))) static inline void check_at(bool ok, const char *file, int line,
                                                                  const char *format, ...) {
  if (ok) return;
  if (++checks_failed_in_test > 5) return;
  va_list arguments;
  va_start(arguments, format);
  printf("    %s:%d: ", file, line);
  vprintf(format, arguments);
  printf("\n");
  va_end(arguments);
}

#define CHECK(condition, ...) check_at((condition), __FILE__, __LINE__, __VA_ARGS__)

static inline void run_test(const char *name, void (*test)(void)) {
  checks_failed_in_test = 0;
  test();
  if (checks_failed_in_test) {
    printf("  FAILED %s (%d checks)\n", name, checks_failed_in_test);
    ++tests_failed;
  } else {
    printf("  ok %s\n", name);
    ++tests_passed;
  }
}

#define RUN(test) run_test(#test, test)

static inline int test_summary(void) {
  printf("%d passed, %d failed\n", tests_passed, tests_failed);
  return tests_failed ? 1 : 0;
}

#endif
