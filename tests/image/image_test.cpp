// SPDX-License-Identifier: MIT
// Images in memory: their shape, their pixels, the table of their channels, and the sRGB curve.
#include "image/image.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <set>

#include "image/channels.hpp"
#include "image/srgb.hpp"
#include "support/expect_error.hpp"

namespace raytorus::image {
namespace {

using test::expectError;

TEST(Image, StartsBlackWithRowsFromTheTopAndChannelsInterleaved) {
    Image image(3, 2, {"R", "Z"});
    EXPECT_EQ(image.pixels, std::vector<float>(12, 0.0f));
    image.pixel(2, 1)[1] = 5.0f;
    image.pixel(1, 0)[0] = 7.0f;
    EXPECT_EQ(image.pixels, (std::vector<float>{0, 0, 7, 0, 0, 0, 0, 0, 0, 0, 0, 5}));
    EXPECT_EQ(std::as_const(image).pixel(2, 1)[1], 5.0f);
}

TEST(Image, FindsChannelsByName) {
    const Image image(1, 1, {"R", "normal.x"});
    EXPECT_EQ(image.channelIndex("R"), 0);
    EXPECT_EQ(image.channelIndex("normal.x"), 1);
    EXPECT_EQ(image.channelIndex("normal"), -1);
    EXPECT_EQ(image.channelIndex(""), -1);
}

bool isOfKind(std::string_view channel, ChannelKind kind) {
    const Quantity* const quantity = findQuantity(channel);
    return quantity != nullptr && quantity->kind == kind;
}

TEST(Channels, ValuesNameMarginsAndTolerancesThatThereAre) {
    for (const Quantity& quantity : quantities) {
        const std::string name(quantity.channels().front());
        EXPECT_TRUE(quantity.margin.empty() || isOfKind(quantity.margin, ChannelKind::Margin)) << name;
        EXPECT_TRUE(quantity.tolerance.empty() || isOfKind(quantity.tolerance, ChannelKind::Tolerance))
            << name;
        EXPECT_EQ(quantity.isOfTruth(), quantity.onMiss.empty()) << name;
    }
    for (const std::string& channel : channelsOf({ChannelKind::Margin, ChannelKind::Tolerance})) {
        EXPECT_TRUE(std::ranges::any_of(quantities, [&channel](const Quantity& quantity) {
            return quantity.margin == channel || quantity.tolerance == channel;
        })) << channel;
    }
}

TEST(Channels, AreDrawnByOneComponentEach) {
    std::set<std::pair<std::size_t, std::size_t>> drawn;
    for (const Quantity& quantity : quantities) {
        for (std::size_t i = 0; i < quantity.channels().size() && !quantity.isOfTruth(); ++i) {
            const std::size_t component = quantity.first.component + i;
            EXPECT_LT(component, 4U) << quantity.channels()[i];
            EXPECT_TRUE(drawn.emplace(quantity.first.image, component).second) << quantity.channels()[i];
        }
    }
    EXPECT_EQ(drawn.size(), 15U);
}

TEST(Image, RefusesShapesThatMakeNoSense) {
    expectError([] { Image(0, 1, {"R"}); }, ExitCode::Internal, {"0 x 1"});
    expectError([] { Image(1, -1, {"R"}); }, ExitCode::Internal, {"1 x -1"});
    expectError([] { Image(maxImageSide + 1, 1, {"R"}); }, ExitCode::Internal, {"65537"});
    expectError([] { Image(1, 1, {}); }, ExitCode::Internal, {"0 channels"});
    expectError([] { Image(1, 1, {"R", "G", "R"}); }, ExitCode::Internal, {"two channels named \"R\""});
    expectError([] { Image(1, 1, {"R", ""}); }, ExitCode::Internal, {"without a name"});
    expectError([] { Image(1, 1, {"\x1b[31m"}); }, ExitCode::Internal, {"control characters"});
    EXPECT_EQ(shapeProblem(maxImageSide, 16384, std::array<std::string, 1>{"R"}), "");
    EXPECT_NE(shapeProblem(maxImageSide, 16385, std::array<std::string, 1>{"R"}), "");
}

TEST(Image, IsFiniteTestsTheBits) {
    using Limits = std::numeric_limits<float>;
    for (const float value : {0.0f, -0.0f, 1.0f, Limits::max(), Limits::lowest(), Limits::denorm_min()}) {
        EXPECT_TRUE(isFinite(value)) << value;
    }
    for (const std::uint32_t bits :
         {0x7f800000u, 0xff800000u, 0x7fc00000u, 0xffc00000u, 0x7f800001u, 0xffffffffu}) {
        EXPECT_FALSE(isFinite(std::bit_cast<float>(bits))) << std::hex << bits;
    }
}

// Element k is the largest float that rounds to the 8 bit value k; the next float rounds to k + 1. Computed
// from the inverse curve with 60 digits, and each pair confirmed with the curve itself.
constexpr std::array<std::uint32_t, 255> largestFloatOf = {
    0x391f22b3u, 0x39eeb40du, 0x3a46eb60u, 0x3a8b3e5du, 0x3ab3070au, 0x3adacfb7u, 0x3b014c32u, 0x3b153088u,
    0x3b2914deu, 0x3b3cf935u, 0x3b50f2d0u, 0x3b65fb9au, 0x3b7c3402u, 0x3b89d05fu, 0x3b962332u, 0x3ba314bcu,
    0x3bb0a730u, 0x3bbedcb6u, 0x3bcdb76cu, 0x3bdd3966u, 0x3bed64aeu, 0x3bfe3b45u, 0x3c07df90u, 0x3c10f91au,
    0x3c1a6b31u, 0x3c2436c7u, 0x3c2e5cc6u, 0x3c38de19u, 0x3c43bba3u, 0x3c4ef647u, 0x3c5a8ee3u, 0x3c668653u,
    0x3c72dd70u, 0x3c7f950eu, 0x3c865701u, 0x3c8d148eu, 0x3c940395u, 0x3c9b247bu, 0x3ca277a5u, 0x3ca9fd77u,
    0x3cb1b652u, 0x3cb9a297u, 0x3cc1c2a8u, 0x3cca16e2u, 0x3cd29fa3u, 0x3cdb5d4au, 0x3ce45031u, 0x3ced78b4u,
    0x3cf6d72du, 0x3d0035fbu, 0x3d051bb3u, 0x3d0a1cebu, 0x3d0f39cfu, 0x3d147289u, 0x3d19c744u, 0x3d1f382bu,
    0x3d24c566u, 0x3d2a6f21u, 0x3d303583u, 0x3d3618b6u, 0x3d3c18e3u, 0x3d423631u, 0x3d4870c9u, 0x3d4ec8d1u,
    0x3d553e72u, 0x3d5bd1d2u, 0x3d628317u, 0x3d695269u, 0x3d703fedu, 0x3d774bc9u, 0x3d7e7623u, 0x3d82df8fu,
    0x3d869371u, 0x3d8a56cau, 0x3d8e29aau, 0x3d920c26u, 0x3d95fe4eu, 0x3d9a0034u, 0x3d9e11ebu, 0x3da23383u,
    0x3da6650fu, 0x3daaa69fu, 0x3daef846u, 0x3db35a14u, 0x3db7cc1au, 0x3dbc4e6au, 0x3dc0e113u, 0x3dc58428u,
    0x3dca37b8u, 0x3dcefbd5u, 0x3dd3d08eu, 0x3dd8b5f4u, 0x3dddac18u, 0x3de2b309u, 0x3de7cad8u, 0x3decf394u,
    0x3df22d4fu, 0x3df77816u, 0x3dfcd3fbu, 0x3e012086u, 0x3e03dfadu, 0x3e06a77au, 0x3e0977f5u, 0x3e0c5125u,
    0x3e0f3313u, 0x3e121dc4u, 0x3e151142u, 0x3e180d94u, 0x3e1b12c1u, 0x3e1e20d0u, 0x3e2137cau, 0x3e2457b5u,
    0x3e278098u, 0x3e2ab27cu, 0x3e2ded67u, 0x3e313160u, 0x3e347e6fu, 0x3e37d49bu, 0x3e3b33ebu, 0x3e3e9c66u,
    0x3e420e14u, 0x3e4588fau, 0x3e490d21u, 0x3e4c9a8fu, 0x3e50314bu, 0x3e53d15cu, 0x3e577ac9u, 0x3e5b2d99u,
    0x3e5ee9d3u, 0x3e62af7du, 0x3e667e9eu, 0x3e6a573du, 0x3e6e3961u, 0x3e722510u, 0x3e761a51u, 0x3e7a192bu,
    0x3e7e21a4u, 0x3e8119e1u, 0x3e8327c6u, 0x3e853a85u, 0x3e875221u, 0x3e896e9cu, 0x3e8b8ffbu, 0x3e8db640u,
    0x3e8fe16fu, 0x3e92118au, 0x3e944695u, 0x3e968094u, 0x3e98bf88u, 0x3e9b0376u, 0x3e9d4c61u, 0x3e9f9a4bu,
    0x3ea1ed37u, 0x3ea4452au, 0x3ea6a225u, 0x3ea9042du, 0x3eab6b43u, 0x3eadd76cu, 0x3eb048a9u, 0x3eb2beffu,
    0x3eb53a70u, 0x3eb7baffu, 0x3eba40b0u, 0x3ebccb84u, 0x3ebf5b80u, 0x3ec1f0a6u, 0x3ec48af8u, 0x3ec72a7bu,
    0x3ec9cf31u, 0x3ecc791du, 0x3ecf2841u, 0x3ed1dca1u, 0x3ed49640u, 0x3ed75520u, 0x3eda1945u, 0x3edce2b1u,
    0x3edfb167u, 0x3ee28569u, 0x3ee55ebcu, 0x3ee83d62u, 0x3eeb215cu, 0x3eee0ab0u, 0x3ef0f95eu, 0x3ef3ed6au,
    0x3ef6e6d7u, 0x3ef9e5a7u, 0x3efce9ddu, 0x3efff37du, 0x3f018144u, 0x3f030b81u, 0x3f049876u, 0x3f062826u,
    0x3f07ba91u, 0x3f094fb8u, 0x3f0ae79eu, 0x3f0c8243u, 0x3f0e1fa9u, 0x3f0fbfd1u, 0x3f1162bdu, 0x3f13086du,
    0x3f14b0e3u, 0x3f165c21u, 0x3f180a28u, 0x3f19baf9u, 0x3f1b6e95u, 0x3f1d24feu, 0x3f1ede35u, 0x3f209a3bu,
    0x3f225912u, 0x3f241abbu, 0x3f25df37u, 0x3f27a688u, 0x3f2970aeu, 0x3f2b3dacu, 0x3f2d0d82u, 0x3f2ee031u,
    0x3f30b5bcu, 0x3f328e23u, 0x3f346967u, 0x3f36478au, 0x3f38288eu, 0x3f3a0c72u, 0x3f3bf339u, 0x3f3ddce4u,
    0x3f3fc974u, 0x3f41b8eau, 0x3f43ab47u, 0x3f45a08eu, 0x3f4798beu, 0x3f4993dau, 0x3f4b91e2u, 0x3f4d92d7u,
    0x3f4f96bcu, 0x3f519d91u, 0x3f53a757u, 0x3f55b410u, 0x3f57c3bdu, 0x3f59d65eu, 0x3f5bebf6u, 0x3f5e0485u,
    0x3f60200du, 0x3f623e8fu, 0x3f64600bu, 0x3f668484u, 0x3f68abfau, 0x3f6ad66fu, 0x3f6d03e4u, 0x3f6f3459u,
    0x3f7167d1u, 0x3f739e4cu, 0x3f75d7cbu, 0x3f781450u, 0x3f7a53dcu, 0x3f7c9670u, 0x3f7edc0du,
};

TEST(Srgb, RoundsToTheNearestAtEveryLimit) {
    for (std::size_t k = 0; k < largestFloatOf.size(); ++k) {
        EXPECT_EQ(encodeSrgb(std::bit_cast<float>(largestFloatOf[k])), k);
        EXPECT_EQ(encodeSrgb(std::bit_cast<float>(largestFloatOf[k] + 1)), k + 1);
    }
}

// Also far from the limits, and where the table of encodeSrgb() goes from one entry to the next.
TEST(Srgb, EveryValueIsBetweenItsLimits) {
    for (std::uint32_t bits = 0; bits < std::bit_cast<std::uint32_t>(1.25f); bits += 0x2000u) {
        for (const std::uint32_t nearby : {bits, bits + 1, bits + 0x1fff}) {
            const auto above = std::ranges::lower_bound(largestFloatOf, nearby);
            EXPECT_EQ(encodeSrgb(std::bit_cast<float>(nearby)), above - largestFloatOf.begin()) << nearby;
        }
    }
}

TEST(Srgb, ClampsWhatIsBelowBlackOrAboveWhite) {
    constexpr float most = std::numeric_limits<float>::max();
    for (const float dark : {0.0f, -0.0f, -1e-30f, -1.0f, -most}) {
        EXPECT_EQ(encodeSrgb(dark), 0) << dark;
        EXPECT_EQ(encodeLinear(dark), 0) << dark;
    }
    for (const float bright : {1.0f, std::nextafter(1.0f, 2.0f), 2.0f, most}) {
        EXPECT_EQ(encodeSrgb(bright), 255) << bright;
        EXPECT_EQ(encodeLinear(bright), 255) << bright;
    }
}

TEST(Srgb, DecodingAndEncodingGivesTheSameBits) {
    for (int stored = 0; stored <= 255; ++stored) {
        EXPECT_EQ(encodeSrgb(decodeSrgb(static_cast<std::uint8_t>(stored))), stored);
    }
    EXPECT_EQ(decodeSrgb(0), 0.0f);
    EXPECT_EQ(decodeSrgb(255), 1.0f);
    EXPECT_NEAR(decodeSrgb(188), 0.50288646f, 1e-7);
    EXPECT_NEAR(decodeSrgb(10), 0.00303527f, 1e-8);  // on the straight piece
}

TEST(Srgb, AlphaHasNoCurve) {
    for (int stored = 0; stored < 255; ++stored) {
        const float value = static_cast<float>(stored) / 255.0f;
        EXPECT_EQ(encodeLinear(value), stored);
        EXPECT_EQ(encodeLinear(value + 0.49f / 255.0f), stored);
        EXPECT_EQ(encodeLinear(value + 0.51f / 255.0f), stored + 1);
    }
}

}  // namespace
}  // namespace raytorus::image
