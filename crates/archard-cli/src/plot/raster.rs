//! PNG pictures with smooth edges.

use std::io::Cursor;

use anyhow::{Result, anyhow, ensure};
use kuva::backend::raster::RasterBackend;
use kuva::render::render::Scene;

/// Pixels drawn along each axis for one that is kept: the library that draws leaves turned text
/// and steep curves jagged.
const OVERSAMPLING: usize = 3;

/// The scene as a PNG of about that width (px).
pub(super) fn png(scene: &Scene, width: f64) -> Result<Vec<u8>> {
    let scale = OVERSAMPLING as f64 * width / scene.width;
    let drawn = RasterBackend::new().with_scale(scale as f32).render_scene(scene);
    shrink(&drawn.map_err(|message| anyhow!(message))?)
}

/// The picture with the mean of each block of pixels in its place.
fn shrink(drawn: &[u8]) -> Result<Vec<u8>> {
    let mut reader = png::Decoder::new(Cursor::new(drawn)).read_info()?;
    let mut pixels = vec![0; reader.output_buffer_size().unwrap_or_default()];
    let info = reader.next_frame(&mut pixels)?;
    ensure!(
        info.bit_depth == png::BitDepth::Eight,
        "the drawn picture has not eight bits a colour"
    );
    let samples = info.color_type.samples();
    let [width, height] = [info.width, info.height].map(|size| size as usize / OVERSAMPLING);
    let mut means = Vec::with_capacity(width * height * samples);
    for y in 0..height {
        for x in 0..width {
            for sample in 0..samples {
                let mut sum = 0_usize;
                for row in 0..OVERSAMPLING {
                    let start = (y * OVERSAMPLING + row) * info.line_size;
                    let first = start + x * OVERSAMPLING * samples + sample;
                    sum += (0..OVERSAMPLING)
                        .map(|column| usize::from(pixels[first + column * samples]))
                        .sum::<usize>();
                }
                means.push((sum / (OVERSAMPLING * OVERSAMPLING)) as u8);
            }
        }
    }
    encode(&means, [width, height], info.color_type)
}

/// Pixels of eight bits a colour as a PNG.
fn encode(pixels: &[u8], [width, height]: [usize; 2], colour: png::ColorType) -> Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width as u32, height as u32);
    encoder.set_color(colour);
    encoder.set_depth(png::BitDepth::Eight);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(pixels)?;
    writer.finish()?;
    Ok(bytes)
}
