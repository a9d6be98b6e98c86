/* user-mode Linux 6.1 gives the extended registers of a guest process back to the host as 2696
 * bytes, their size up to AVX-512. A host whose processor has more (AMX: 11008 bytes) accepts only
 * its own complete state and otherwise answers EFAULT. Then the guest's first process dies. This
 * library is preloaded into linux.uml and fills the rest with zeros: the state of registers that
 * were never used. */
#include <cpuid.h>
#include <dlfcn.h>
#include <elf.h>
#include <linux/ptrace.h>
#include <string.h>
#include <sys/types.h>
#include <sys/uio.h>

enum { most_bytes = 1 << 16 };
typedef long ptrace_function(int request, pid_t process, void* address, void* data);

static ptrace_function* c_library_ptrace;
static unsigned state_bytes; /* XSAVE area of the features that this machine has switched on */

__attribute__((constructor)) static void look_up(void) {
  unsigned all, ecx, edx;
  *(void**)&c_library_ptrace = dlsym(RTLD_NEXT, "ptrace");
  if (!__get_cpuid_count(0x0D, 0, &all, &state_bytes, &ecx, &edx)) state_bytes = 0;
}

long ptrace(int request, pid_t process, void* address, void* data) {
  static char state[most_bytes];
  const struct iovec* given = data;
  struct iovec whole = {state, state_bytes};
  if (request != PTRACE_SETREGSET || address != (void*)NT_X86_XSTATE ||
      given->iov_len >= state_bytes || state_bytes > most_bytes)
    return c_library_ptrace(request, process, address, data);
  memcpy(state, given->iov_base, given->iov_len);
  memset(state + given->iov_len, 0, state_bytes - given->iov_len);
  return c_library_ptrace(request, process, address, &whole);
}
