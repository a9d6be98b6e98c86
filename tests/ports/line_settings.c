/* QEMU sets the guest's rate, parity, data and stop bits on the pseudo-terminal that stands for a
 * serial port (tcsetattr). Linux's pty forgets parity and data bits. This library is preloaded into
 * QEMU and also writes the control flags (four bytes, c_cflag) to the file
 * $DRYDOCK_LINE_SETTINGS/N, where N is the number of the terminal, for null_modem.py. */
#include <dlfcn.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <termios.h>
#include <unistd.h>

typedef int tcsetattr_function(int fd, int when, const struct termios* settings);

static void tell(int fd, tcflag_t flags) {
  const char* folder = getenv("DRYDOCK_LINE_SETTINGS");
  char terminal[64], path[4096];
  if (!folder || ttyname_r(fd, terminal, sizeof terminal) != 0) return;
  snprintf(path, sizeof path, "%s/%s", folder, strrchr(terminal, '/') + 1);
  const int file = open(path, O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  if (file < 0 || pwrite(file, &flags, sizeof flags, 0) != sizeof flags) perror(path);
  if (file >= 0) close(file);
}

int tcsetattr(int fd, int when, const struct termios* settings) {
  tcsetattr_function* c_library_tcsetattr;
  *(void**)&c_library_tcsetattr = dlsym(RTLD_NEXT, "tcsetattr");
  tell(fd, settings->c_cflag);
  return c_library_tcsetattr(fd, when, settings);
}
