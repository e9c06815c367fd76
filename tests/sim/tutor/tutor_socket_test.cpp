#include "sim/tutor/tutor_socket.h"

#include <sys/stat.h>
#include <sys/un.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <set>

#include "tests/sim/tutor_fixture.h"
#include "textures/base/error.h"

namespace moontrace {
namespace {

class TutorSocketFile : public TutorTest {};

std::string WhyNot(const std::function<void()>& act) {
  try {
    act();
  } catch (const LackError& error) {
    return error.what();
  }
  return {};
}

unsigned ModeOf(const std::string& path) {
  struct stat found {};
  EXPECT_EQ(lstat(path.c_str(), &found), 0);
  return found.st_mode & 07777U;
}

TEST(TutorPeer, IsTheOwnerByUserIdOnly) {
  EXPECT_TRUE(IsOwner({1, 1000, 5}, 1000));
  EXPECT_FALSE(IsOwner({1, 1001, 1000}, 1000));
  EXPECT_FALSE(IsOwner({1, 0, 0}, 1000));  // not even root
  EXPECT_FALSE(IsOwner({1, static_cast<uid_t>(-1), 0}, 0));
}

TEST(TutorPeer, OfWhichTheSystemTellsNothingIsNoOwner) {
  EXPECT_FALSE(PeerIsOwner(-1));
  int ends[2];
  ASSERT_EQ(socketpair(AF_UNIX, SOCK_STREAM, 0, ends), 0);
  EXPECT_TRUE(PeerIsOwner(ends[0]));  // ourselves
  close(ends[0]);
  close(ends[1]);
}

TEST(TutorSocketName, IsOneOfAFileAndLeadsBackToTheLearner) {
  EXPECT_EQ(TutorSocketName("ada"), "tutor-ada.sock");
  EXPECT_EQ(TutorSocketName("a/b c"), "tutor-a%2Fb%20c.sock");
  for (const char* learner : {"ada", "a/b", "..", "50%41", "\xC3\xA4", "a\nb", "%", "%4"}) {
    const std::string name = TutorSocketName(learner);
    EXPECT_EQ(name.find('/'), std::string::npos);
    EXPECT_EQ(LearnerOfSocket(name), learner);
  }
  EXPECT_EQ(LearnerOfSocket("tutor-ada.sock.lock"), "");
  EXPECT_EQ(LearnerOfSocket("other-ada.sock"), "");
  EXPECT_EQ(LearnerOfSocket("tutor-.sock"), "");
}

TEST(TutorSocketName, OfLongNamesStaysShortAndDiffers) {
  std::set<std::string> names;
  for (int i = 0; i < 100; ++i) {
    const std::string name = TutorSocketName(std::string(200, 'a') + std::to_string(i));
    EXPECT_LE(name.size(), 72U);
    names.insert(name);
  }
  EXPECT_EQ(names.size(), 100U);
}

TEST_F(TutorSocketFile, AndItsFolderAreTheOwnersAlone) {
  RequireTutorFolder(folder());
  EXPECT_EQ(ModeOf(folder()), 0700U);
  const TutorSocket socket(folder() + "/tutor-ada.sock");
  EXPECT_EQ(ModeOf(socket.path()), 0600U);
  EXPECT_EQ(ModeOf(socket.path() + ".lock"), 0600U);
  EXPECT_EQ(TutorFolder(), folder());
}

TEST_F(TutorSocketFile, FolderThatOthersMayEnterOrThatIsNoneIsRefused) {
  std::filesystem::create_directory(folder());
  ASSERT_EQ(chmod(folder().c_str(), 0750), 0);
  EXPECT_EQ(WhyNot([this] { RequireTutorFolder(folder()); }),
            "no tutor can come: others may enter the folder for its socket; close it with chmod "
            "700: " +
                folder());
  std::filesystem::remove(folder());
  std::filesystem::create_directory_symlink(runtime_, folder());  // a trap in a folder like /tmp
  const std::string refused = WhyNot([this] { RequireTutorFolder(folder()); });
  EXPECT_NE(refused.find("is another user's or no folder"), std::string::npos) << refused;
}

TEST_F(TutorSocketFile, WithoutARuntimeFolderIsInOneOfTheUsersInTmp) {
  unsetenv("XDG_RUNTIME_DIR");
  EXPECT_EQ(TutorFolder(), "/tmp/moontrace-" + std::to_string(getuid()));
  setenv("XDG_RUNTIME_DIR", "relative", 1);  // not to be heeded by its specification
  EXPECT_EQ(TutorFolder(), "/tmp/moontrace-" + std::to_string(getuid()));
}

TEST_F(TutorSocketFile, OfALiveProgramIsRefusedInOneLine) {
  RequireTutorFolder(folder());
  const std::string path = folder() + "/tutor-ada.sock";
  const TutorSocket first(path);
  EXPECT_EQ(
      WhyNot([&path] { const TutorSocket second(path); }),
      "the tutor socket is already taken: another lesson of this learner runs; end it, or use "
      "another --learner: " +
          path);
  EXPECT_TRUE(ConnectTo(path));  // and the first one is none the worse
  const TutorSocket other(folder() + "/tutor-bob.sock");
  EXPECT_EQ(LearnersWithTutorSockets(folder()), (std::vector<std::string>{"ada", "bob"}));
}

TEST_F(TutorSocketFile, OfADeadProgramIsTakenOver) {
  RequireTutorFolder(folder());
  const std::string path = folder() + "/tutor-ada.sock";
  {  // bound and never removed, with a lock file that nobody holds
    const FileDescriptor dead(socket(AF_UNIX, SOCK_STREAM, 0));
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, path.c_str(), sizeof address.sun_path - 1);
    ASSERT_EQ(bind(dead.get(), reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
    std::ofstream(path + ".lock") << "";
  }
  EXPECT_TRUE(LearnersWithTutorSockets(folder()).empty());
  EXPECT_FALSE(ConnectTo(path));
  const TutorSocket socket(path);
  EXPECT_TRUE(ConnectTo(path));
}

TEST_F(TutorSocketFile, DoesNotRemoveWhatIsNoSocket) {
  RequireTutorFolder(folder());
  const std::string path = folder() + "/tutor-ada.sock";
  std::ofstream(path) << "precious";
  const std::string refused = WhyNot([&path] { const TutorSocket socket(path); });
  EXPECT_EQ(refused.find("the tutor socket has no place"), 0U) << refused;
  EXPECT_EQ(std::filesystem::file_size(path), 8U);
}

TEST_F(TutorSocketFile, LeavesNothingBehind) {
  RequireTutorFolder(folder());
  { const TutorSocket socket(folder() + "/tutor-ada.sock"); }
  EXPECT_TRUE(std::filesystem::is_empty(folder()));
  EXPECT_TRUE(LearnersWithTutorSockets(folder()).empty());
}

TEST_F(TutorSocketFile, WithAPathTooLongIsRefused) {
  const std::string path = runtime_ + "/" + std::string(120, 'a');
  const std::string refused = WhyNot([&path] { const TutorSocket socket(path); });
  EXPECT_EQ(refused.find("no tutor can come: the socket cannot be opened"), 0U) << refused;
}

}  // namespace
}  // namespace moontrace
