/* The parts of c_api_test, a file each. */
#ifndef HONEYCOMB_TESTS_CAPI_PARTS_H
#define HONEYCOMB_TESTS_CAPI_PARTS_H

void test_meshes(const char* folder); /* where files may be written */
void test_tables(void);
void test_evaluation(void);
void test_files(const char* folder);
void test_vulkan_absent(void); /* of a build without it; with it: c_vulkan_test.c */

#endif
