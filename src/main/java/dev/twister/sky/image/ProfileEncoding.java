package dev.twister.sky.image;

import java.awt.color.CMMException;
import java.awt.color.ColorSpace;
import java.awt.color.ICC_ColorSpace;
import java.awt.color.ICC_Profile;
import java.awt.color.ProfileDataException;
import java.awt.image.ColorConvertOp;
import java.awt.image.DataBuffer;
import java.awt.image.Raster;
import java.awt.image.WritableRaster;
import java.io.IOException;
import java.util.Optional;

/** Samples of which an ICC profile says what they are. */
final class ProfileEncoding implements ColorEncoding {
    private static final int LARGEST = 65_535;
    private static final int LARGEST_BYTE = 255;
    private static final ICC_Profile SRGB = ICC_Profile.getInstance(ColorSpace.CS_sRGB);

    /** A profile that moves no sample by more than one of 255 is sRGB, rounded. */
    private static final int ROUNDING = LARGEST / 255;

    private static final int COMPARED_STEPS = 6;

    private final ICC_Profile profile;

    private ProfileEncoding(ICC_Profile profile) {
        this.profile = profile;
    }

    /**
     * The encoding that a profile stands for.
     *
     * @param data an ICC profile
     * @param channels 1 for a gray image, 3 for one of red, green and blue
     * @throws IOException where it is damaged, or not for such images; as {@link #ignored} tells
     */
    static ColorEncoding of(byte[] data, int channels) throws IOException {
        try {
            ProfileEncoding encoding = new ProfileEncoding(ICC_Profile.getInstance(data));
            encoding.checkKind(channels);
            // The way back is tried too: it is what the JPEG decoder goes by.
            new ICC_ColorSpace(encoding.profile).fromRGB(new float[] {1, 0, 0});
            return encoding.isSrgb(channels) ? CurveEncoding.SRGB : encoding;
        } catch (IllegalArgumentException | CMMException | ProfileDataException damaged) {
            throw new IOException("is damaged", damaged);
        }
    }

    /** The warning that a profile is not used. */
    static String ignored(IOException unusable) {
        return "its color profile " + unusable.getMessage() + " and is ignored";
    }

    @Override
    public ColorRows rows(int width, int channels, int largest) {
        ColorConvertOp conversion = new ColorConvertOp(new ICC_Profile[] {profile, SRGB}, null);
        // Samples of 8 bits are converted to 8 bits, as the JPEG decoder does: far faster than at 16 bits.
        int converted = largest > LARGEST_BYTE ? LARGEST : LARGEST_BYTE;
        WritableRaster from = raster(width, channels, converted);
        WritableRaster to = raster(width, 3, converted);
        int[] encoded = new int[3 * width];
        int[] scaled = new int[channels * width];
        ColorRows.Recoding recoding = samples -> {
            for (int i = 0; i < scaled.length; i++) {
                scaled[i] = samples[i] * (converted / largest);
            }
            from.setPixels(0, 0, width, 1, scaled);
            conversion.filter(from, to);
            to.getPixels(0, 0, width, 1, encoded);
            if (channels == 1) {
                keepGray(encoded);
            }
            return encoded;
        };
        return new ColorRows(recoding, CurveEncoding.SRGB.table(converted), Optional.empty());
    }

    /** Conversion rounds each channel on its own, but gray stays gray. */
    private static void keepGray(int[] encoded) {
        for (int i = 0; i < encoded.length; i += 3) {
            encoded[i] = encoded[i + 1];
            encoded[i + 2] = encoded[i + 1];
        }
    }

    private void checkKind(int channels) throws IOException {
        boolean forImages = switch (profile.getProfileClass()) {
            case ICC_Profile.CLASS_DEVICELINK, ICC_Profile.CLASS_ABSTRACT, ICC_Profile.CLASS_NAMEDCOLOR -> false;
            default -> true;
        };
        int type = profile.getColorSpaceType();
        if (!forImages || type != (channels == 1 ? ColorSpace.TYPE_GRAY : ColorSpace.TYPE_RGB)) {
            throw new IOException("is for another kind of image");
        }
    }

    private boolean isSrgb(int channels) {
        int colors = channels == 1 ? COMPARED_STEPS : COMPARED_STEPS * COMPARED_STEPS * COMPARED_STEPS;
        WritableRaster from = raster(colors, channels, LARGEST);
        for (int color = 0; color < colors; color++) {
            int rest = color;
            for (int channel = 0; channel < channels; channel++) {
                from.setSample(color, 0, channel, rest % COMPARED_STEPS * LARGEST / (COMPARED_STEPS - 1));
                rest /= COMPARED_STEPS;
            }
        }
        WritableRaster to = raster(colors, 3, LARGEST);
        new ColorConvertOp(new ICC_Profile[] {profile, SRGB}, null).filter(from, to);
        for (int color = 0; color < colors; color++) {
            for (int channel = 0; channel < 3; channel++) {
                int before = from.getSample(color, 0, channels == 1 ? 0 : channel);
                if (Math.abs(to.getSample(color, 0, channel) - before) > ROUNDING) {
                    return false;
                }
            }
        }
        return true;
    }

    private static WritableRaster raster(int width, int channels, int largest) {
        int type = largest == LARGEST ? DataBuffer.TYPE_USHORT : DataBuffer.TYPE_BYTE;
        return Raster.createInterleavedRaster(type, width, 1, channels, null);
    }
}
