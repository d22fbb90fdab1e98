#include "app/wire/content_hash.h"

#include <openssl/core_names.h>
#include <openssl/evp.h>
#include <openssl/params.h>

#include <stdexcept>

namespace pdr::wire {

struct ContentHash::State {
    EVP_MAC* mac = EVP_MAC_fetch(nullptr, "BLAKE2BMAC", nullptr);
    EVP_MAC_CTX* context = EVP_MAC_CTX_new(mac);

    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() {
        EVP_MAC_CTX_free(context);
        EVP_MAC_free(mac);
    }
};

namespace {

const unsigned char* data(std::span<const std::byte> bytes) {
    return reinterpret_cast<const unsigned char*>(bytes.data());
}

/// Throws if OpenSSL fails: without the hash no content can be verified.
void require(int success) {
    if (success != 1)
        throw std::runtime_error("OpenSSL has no keyed BLAKE2b, or no memory for it");
}

}  // namespace

void ContentHash::Free::operator()(State* state) const {
    delete state;
}

ContentHash::ContentHash(std::span<const std::byte> key) : state_(new State) {
    std::size_t bytes = std::tuple_size_v<Hash>;
    const OSSL_PARAM parameters[]{OSSL_PARAM_construct_size_t(OSSL_MAC_PARAM_SIZE, &bytes), OSSL_PARAM_construct_end()};
    require(EVP_MAC_init(state_->context, data(key), key.size(), parameters));
}

void ContentHash::add(std::span<const std::byte> bytes) {
    require(EVP_MAC_update(state_->context, data(bytes), bytes.size()));
}

Hash ContentHash::finish() {
    Hash hash;
    std::size_t bytes = 0;
    require(EVP_MAC_final(state_->context, reinterpret_cast<unsigned char*>(hash.data()), &bytes, hash.size()));
    return hash;
}

Hash sumsHash(std::span<const std::byte> key, std::span<const PixelSums> sums, std::span<const Moments> moments) {
    ContentHash hash(key);
    hash.add(std::as_bytes(sums));
    hash.add(std::as_bytes(moments));
    return hash.finish();
}

Hash contentHash(std::span<const std::byte> key, std::span<const std::byte> bytes) {
    ContentHash hash(key);
    hash.add(bytes);
    return hash.finish();
}

}  // namespace pdr::wire
