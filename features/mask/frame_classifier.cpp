#include "features/mask/frame_classifier.h"

#include "features/mask/avx2_classifier.h"
#include "features/mask/avx512_classifier.h"
#include "features/mask/portable_classifier.h"
#include "features/mask/red_sector_test.h"

namespace lineservo::features {

std::unique_ptr<FrameClassifier> make_classifier(const SegmenterOptions& options, cv::Size frame_size,
                                                 Processor processor) {
#if defined(__x86_64__)
  // Colours whose bounds do not fit the byte-wise form take the portable loop, which knows every colour.
  const std::optional<RedSectorTest> test = make_red_sector_test(options);
  if (processor == Processor::avx512 && test && Avx512Classifier::fits(options, frame_size))
    return std::make_unique<Avx512Classifier>(options, *test, frame_size);
  if (processor != Processor::portable && test)
    return std::make_unique<Avx2Classifier>(options, *test, frame_size);
#endif
  return std::make_unique<PortableClassifier>(options, frame_size);
}

}  // namespace lineservo::features
