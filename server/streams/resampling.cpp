#include "server/streams/resampling.h"

#include "common/memory.h"
#include "common/sources/resample.h"
#include "common/sources/source_reader.h"

namespace aucast::server {

Result<void> resample(protocol::StreamFile& stream, double rate, std::uint32_t keyframe_ms,
                      const std::filesystem::path& path, const std::stop_token& stop) {
  const auto ms = static_cast<double>(protocol::media_ms(stream, keyframe_ms));
  const auto keyframes = static_cast<std::uint64_t>(ms * rate / 1000);
  auto can = check_memory(path, keyframes * sources::kWholeKeyframeBytes,
                          "lower --rate or choose a shorter stream");
  if (!can) return can;
  stream = sources::resample(stream, rate, keyframe_ms, stop);
  return {};
}

}  // namespace aucast::server
