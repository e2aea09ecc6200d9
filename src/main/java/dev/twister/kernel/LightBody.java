package dev.twister.kernel;

/** Which bodies are lights. */
final class LightBody {
    private LightBody() {}

    /** 1 if the body is a light, else 0. */
    static int isLight(int body, float[] frame, int variant) {
        int isLight = body == Layout.LIGHT ? 1 : 0;
        if ((variant & Variant.LIGHTS) != 0) {
            float second = frame[Layout.SECOND_LIGHT];
            isLight = isLight | ((body >= second ? 1 : 0) & (body < second + frame[Layout.LIGHTS] - 1f ? 1 : 0));
        }
        return isLight;
    }

    /** A light's body. */
    static int at(int index, float[] frame) {
        return index == 0 ? Layout.LIGHT : (int) frame[Layout.SECOND_LIGHT] + index - 1;
    }

    /** The body of the light that shades now: the only one, or {@link Layout#SHADING_LIGHT}. */
    static int shading(float[] path, int variant) {
        int light = Layout.LIGHT;
        if ((variant & Variant.LIGHTS) != 0) {
            light = (int) path[Layout.SHADING_LIGHT];
        }
        return light;
    }
}
