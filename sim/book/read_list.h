#pragma once

#include <string>
#include <vector>

#include "sim/console/console.h"

/// What was read: the list that `read` alone says, the newest first, with numbers from 1.
namespace moontrace {

/// What a file of it is known by: absolute, links followed; empty for standard input, "-".
std::string PathOfRead(const std::string& file);

/// Says what was read last, with its places; of one learner, if one is named. `records`: path;
/// there may be none yet. Throws as Records.
void ListReadings(const std::string& learner, const std::string& records, bool json,
                  Console& console);

/// A file of the list, and who reads it there.
struct ListedFile {
  std::string path, learner, title;
};
/// Those that can be read on, the newest first. `learner`, `records`: as ListReadings.
std::vector<ListedFile> FilesToReadOn(const std::string& learner, const std::string& records);
/// By its number. Throws InputError: there is none, its file is gone, holds another text now, or
/// was standard input.
ListedFile FileNumbered(const std::string& number, const std::string& learner,
                        const std::string& records);

/// Forgets place and bookmarks of a text, which cannot be undone: by its number, or by its file, of
/// which it is what was read there last. Throws InputError: there is none; as Records.
void ForgetReading(const std::string& given, const std::string& learner, const std::string& records,
                   Console& console);

}  // namespace moontrace
