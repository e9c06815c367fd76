#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "sim/study/study_protocol.h"
#include "sim/study/study_row.h"

namespace moontrace {

/// One learner of a study.
struct StudyPlace {
  std::size_t condition = 0;  ///< index into StudyProtocol::conditions
  std::uint64_t seed = 0;
};

/// All learners of a protocol, condition by condition; of shard `shard` of `shards` (from 1) every
/// `shards`th one.
std::vector<StudyPlace> PlacesOf(const StudyProtocol& protocol, int shard, int shards);

/// How many rows one learner has.
std::size_t RowsOf(const StudyProtocol& protocol, const StudyPlace& place);

/// Runs the trials of one learner that are not among `rows`, its first ones; `each` is given every
/// new row as soon as it is finished, and may throw to stop, as may `check`, if given, which is
/// called within long ones. What the learner had learnt is relived
/// from the rows' felt errors. Throws InputError: rows of another study.
void RunStudyLearner(const StudyProtocol& protocol, const StudyPlace& place,
                     const std::vector<StudyRow>& rows,
                     const std::function<void(const StudyRow&)>& each,
                     const std::function<void()>& check = {});

}  // namespace moontrace
