// Threads that must not wait for the machine's other work.
#pragma once

#include <pthread.h>
#include <sched.h>

namespace searig::acquisition {

/// Asks for the lowest real-time priority for the calling thread: it sleeps nearly always, and when
/// something comes it goes before every ordinary program. Where this user may not have that, all
/// stays as it is.
inline void prefer_this_thread() {
  sched_param parameters{};
  parameters.sched_priority = sched_get_priority_min(SCHED_RR);
  pthread_setschedparam(pthread_self(), SCHED_RR, &parameters);
}

}  // namespace searig::acquisition
