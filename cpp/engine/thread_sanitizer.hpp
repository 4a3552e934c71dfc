#pragma once
/// \file
/// Whether the thread sanitizer watches.  It sees nothing of what oneTBB does to order
/// its threads, so that under it loops have threads of their own.

#if defined(__SANITIZE_THREAD__)
#define CERTET_THREAD_SANITIZER
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define CERTET_THREAD_SANITIZER
#endif
#endif
