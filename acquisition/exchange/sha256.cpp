#include "acquisition/exchange/sha256.h"

#include <openssl/evp.h>

#include <memory>
#include <stdexcept>

#include "acquisition/recording/mapped_file.h"

namespace searig::acquisition::exchange {

std::string sha256_of(const std::filesystem::path& path) {
  const MappedFile file(path);
  unsigned char digest[EVP_MAX_MD_SIZE];
  unsigned size = 0;
  if (EVP_Digest(file.bytes().data(), file.bytes().size(), digest, &size, EVP_sha256(), nullptr) !=
      1)
    throw std::runtime_error("the SHA-256 of " + path.string() + " cannot be computed.");
  constexpr char digits[] = "0123456789abcdef";
  std::string text;
  for (unsigned i = 0; i < size; ++i) {
    text += digits[digest[i] >> 4];
    text += digits[digest[i] & 15];
  }
  return text;
}

}  // namespace searig::acquisition::exchange
