#pragma once

#include <sys/socket.h>
#include <sys/types.h>

#include <string>
#include <vector>

#include "textures/base/file_descriptor.h"

namespace moontrace {

/// Where tutors' sockets are: `$XDG_RUNTIME_DIR/moontrace`, without that `/tmp/moontrace-UID`.
std::string TutorFolder();
/// Makes the folder with mode 0700. Throws LackError: another user's, a link, no folder, or open to
/// others; then nothing of it is used.
void RequireTutorFolder(const std::string& folder);

/// `tutor-NAME.sock`; bytes that do not belong into a file's name as %XX, a name too long for a
/// socket cut, with a checksum of the whole.
std::string TutorSocketName(const std::string& learner);
/// Who is meant by such a name: the learner, or what is left of it; empty for other names.
std::string LearnerOfSocket(const std::string& file_name);

/// Whether the program at the other end belongs to this user.
inline bool IsOwner(const ucred& peer, uid_t self) noexcept { return peer.uid == self; }
/// The same for a connected socket; false where the system does not say.
bool PeerIsOwner(int fd) noexcept;

/// A listening socket with mode 0600 that is removed with its owner. A locked file beside it shows
/// that the owner lives, so that what a dead program left is taken over without a race.
class TutorSocket {
 public:
  /// Throws LackError: a live program has it, something else lies there, the system refuses.
  explicit TutorSocket(const std::string& path);
  ~TutorSocket();
  TutorSocket(const TutorSocket&) = delete;
  TutorSocket& operator=(const TutorSocket&) = delete;
  int fd() const { return listening_.get(); }
  const std::string& path() const { return path_; }

 private:
  std::string path_, lock_path_;
  FileDescriptor lock_, listening_;
};

/// Learners whose lessons can be spoken to now, sorted. Throws as RequireTutorFolder, but a folder
/// that is not there holds none.
std::vector<std::string> LearnersWithTutorSockets(const std::string& folder);

}  // namespace moontrace
