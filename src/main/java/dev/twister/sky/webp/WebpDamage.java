package dev.twister.sky.webp;

import java.io.IOException;

/** What is wrong with a damaged file. */
final class WebpDamage {
    private WebpDamage() {}

    static IOException truncated() {
        return new IOException("the WebP ends before its last texel");
    }

    static IOException damaged(String what) {
        return new IOException("a damaged WebP (" + what + ")");
    }

    static void check(boolean right, String wrong) throws IOException {
        if (!right) {
            throw damaged(wrong);
        }
    }
}
