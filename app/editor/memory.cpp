#include <jemalloc/jemalloc.h>

// What jemalloc begins with (its manual, "TUNING"). The thread of the window allocates beside some thirty
// others: glibc's allocator makes it wait for their locks, and gives memory back to the system that the next
// answer asks for again, page by page. Here every thread has a cache, and what is free stays for a while.
extern "C" const char* malloc_conf;
const char* malloc_conf = "background_thread:true,dirty_decay_ms:30000";
