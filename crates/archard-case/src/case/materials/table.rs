//! The table of materials: a line each.

use super::HandbookMaterial;

/// 1 HV or 1 HBW (1 kgf/mm^2) in Pa (ISO 6507-1, ISO 6506-1).
const HV: f64 = 9.806_65e6;
const GPA: f64 = 1e9;

const ASHBY: &str =
    "M. F. Ashby, Materials Selection in Mechanical Design, appendix: middle of the range";
const ASM1: &str = "ASM Handbook vol. 1, Irons, Steels, and High-Performance Alloys";
const ASM2: &str = "ASM Handbook vol. 2, Nonferrous Alloys and Special-Purpose Materials";

const fn given(value: f64) -> Option<f64> {
    if value > 0.0 { Some(value) } else { None }
}

/// Elasticity (GPa, -), density (kg/m^3), hardness (HV or HBW), conductivity (W/(m K)) and specific heat (J/(kg K)); 0 for what is not known.
const fn material(
    names: (&'static str, &'static [&'static str]),
    state: &'static str,
    [young, poisson, density, hardness, conductivity, heat]: [f64; 6],
    source: &'static str,
) -> HandbookMaterial {
    let (name, also) = names;
    let (hardness, conductivity, heat) = (given(hardness * HV), given(conductivity), given(heat));
    HandbookMaterial {
        name,
        also,
        state,
        young: young * GPA,
        poisson,
        density,
        hardness,
        conductivity,
        heat,
        source,
    }
}

/// All of them: E (GPa), nu, density (kg/m^3), HV or HBW, conductivity (W/(m K)), specific heat (J/(kg K)).
#[rustfmt::skip]
pub const MATERIALS: &[HandbookMaterial] = &[
    // Steels. Hardness of hardened steels from HRC by ASTM E140.
    material(("100Cr6", &["AISI 52100", "52100", "SUJ2", "1.3505"]), "bearing steel, hardened to 62 HRC", [210.0, 0.30, 7810.0, 746.0, 46.6, 475.0], "ASM Handbook vol. 1 (AISI 52100)"),
    material(("440C", &["X105CrMo17", "1.4125"]), "stainless bearing steel, hardened to 58 HRC", [200.0, 0.28, 7800.0, 653.0, 24.2, 460.0], ASM1),
    material(("18CrNiMo7-6", &["1.6587"]), "gear steel, case-hardened to 60 HRC", [206.0, 0.30, 7830.0, 697.0, 0.0, 0.0], "ISO 6336-1 (elasticity) and -5 (hardness of the case)"),
    material(("42CrMo4", &["AISI 4140", "1.7225"]), "quenched and tempered to 300 HBW", [210.0, 0.29, 7850.0, 300.0, 42.6, 473.0], "ASM Handbook vol. 1 (AISI 4140)"),
    material(("C45", &["AISI 1045", "1.0503"]), "carbon steel, normalised", [206.0, 0.29, 7850.0, 170.0, 49.8, 486.0], "ASM Handbook vol. 1 (AISI 1045)"),
    material(("S235", &["S235JR", "St37", "1.0038"]), "structural steel, as rolled", [210.0, 0.30, 7850.0, 120.0, 53.3, 440.0], "EN 1993-1-1 and EN 1993-1-2; hardness of 400 MPa tensile strength, ISO 18265"),
    material(("R260", &[]), "rail steel, head of the rail (260 to 300 HBW)", [210.0, 0.30, 7850.0, 280.0, 47.8, 490.0], "EN 13674-1; heat: ASM Handbook vol. 1 (0.8 % C)"),
    material(("ER7", &[]), "wheel steel, rim (235 HBW at least)", [210.0, 0.30, 7850.0, 250.0, 49.8, 486.0], "EN 13262; heat: ASM Handbook vol. 1 (0.45 % C)"),
    material(("304", &["AISI 304", "X5CrNi18-10", "1.4301"]), "austenitic stainless steel, annealed", [200.0, 0.29, 7900.0, 160.0, 15.0, 500.0], "EN 10088-1; hardness: ASM Handbook vol. 1"),
    material(("316L", &["AISI 316L", "X2CrNiMo17-12-2", "1.4404"]), "austenitic stainless steel, annealed", [200.0, 0.29, 8000.0, 150.0, 15.0, 500.0], "EN 10088-1; hardness: ASM Handbook vol. 1"),
    // Cast irons.
    material(("GJL-250", &["EN-GJL-250", "GG25"]), "grey cast iron (180 to 220 HBW)", [110.0, 0.26, 7200.0, 200.0, 48.5, 460.0], "EN 1561, annex; conductivity at 100 degC"),
    material(("GJS-500-7", &["EN-GJS-500-7", "GGG50"]), "spheroidal cast iron (170 to 230 HBW)", [169.0, 0.275, 7100.0, 200.0, 35.2, 515.0], "EN 1563, annex; conductivity at 300 degC"),
    // Other metals.
    material(("Ti-6Al-4V", &["TiAl6V4", "3.7165"]), "titanium alloy, annealed", [114.0, 0.34, 4430.0, 349.0, 6.7, 526.0], "R. Boyer et al., Materials Properties Handbook: Titanium Alloys"),
    material(("Al 6061-T6", &["6061-T6", "6061"]), "aluminium alloy, aged (95 HBW)", [68.9, 0.33, 2700.0, 95.0, 167.0, 896.0], ASM2),
    material(("Al 7075-T6", &["7075-T6", "7075"]), "aluminium alloy, aged (150 HBW)", [71.7, 0.33, 2810.0, 150.0, 130.0, 960.0], ASM2),
    material(("Cu", &["copper", "Cu-ETP", "C11000"]), "copper, half-hard (65 to 95 HV)", [117.0, 0.34, 8940.0, 80.0, 390.0, 385.0], "ASM Handbook vol. 2 (C11000); hardness: EN 1652, H065"),
    material(("CuZn39Pb3", &["brass", "CW614N"]), "free-cutting brass, half-hard", [97.0, 0.34, 8470.0, 120.0, 123.0, 377.0], "ASM Handbook vol. 2 (C38500)"),
    material(("CuSn8", &["bronze", "CuSn8P", "C52100"]), "wrought bearing bronze (80 to 160 HBW)", [115.0, 0.34, 8800.0, 120.0, 59.0, 377.0], "ISO 4382-2; specific heat: ASM Handbook vol. 2 (C52100)"),
    material(("Inconel 718", &["NiCr19Fe19Nb5Mo3", "2.4668", "718"]), "nickel alloy, aged to 40 HRC", [200.0, 0.29, 8220.0, 392.0, 11.4, 435.0], "Special Metals, bulletin SMC-045"),
    material(("CoCrMo", &["Co28Cr6Mo", "ASTM F75"]), "cobalt alloy for implants, cast, 30 HRC", [230.0, 0.30, 8300.0, 302.0, 0.0, 0.0], "ISO 5832-4; ASM Handbook vol. 23, Materials for Medical Devices: typical"),
    material(("tungsten", &["W"]), "sintered and worked", [411.0, 0.28, 19250.0, 0.0, 174.0, 132.0], "CRC Handbook of Chemistry and Physics; elasticity: ASM Handbook vol. 2"),
    // Hard metals and ceramics.
    material(("WC-Co", &["WC-6Co", "tungsten carbide", "hardmetal"]), "cemented carbide of 6 % Co, medium grain", [640.0, 0.21, 14950.0, 1550.0, 100.0, 0.0], "ASM Handbook vol. 2, chapter on cemented carbides: typical"),
    material(("Al2O3", &["alumina"]), "sintered alumina, 99.5 % and more", [416.0, 0.231, 3984.0, 1530.0, 33.0, 755.0], "R. G. Munro, J. Am. Ceram. Soc. 80 (1997) 1919"),
    material(("Si3N4", &["silicon nitride"]), "silicon nitride of bearing balls", [310.0, 0.27, 3200.0, 1550.0, 26.0, 730.0], "ISO 26602 (elasticity, density, hardness: typical); heat: Ashby"),
    material(("ZrO2", &["zirconia", "3Y-TZP", "Y-TZP"]), "zirconia with 3 mol % yttria, 3Y-TZP", [205.0, 0.31, 6050.0, 1250.0, 2.5, 450.0], "ISO 13356; R. Morrell, Handbook of Properties of Technical and Engineering Ceramics: typical"),
    material(("SiC", &["silicon carbide"]), "silicon carbide, sintered", [415.0, 0.16, 3160.0, 0.0, 114.0, 715.0], "R. G. Munro, J. Phys. Chem. Ref. Data 26 (1997) 1195"),
    material(("sapphire", &[]), "single crystal of alumina, mean over its directions", [403.0, 0.23, 3980.0, 2100.0, 40.0, 760.0], "E. R. Dobrovinskaya et al., Sapphire: Material, Manufacturing, Applications (2009): typical"),
    material(("silicon", &["Si"]), "mean over the directions of the crystal", [163.0, 0.22, 2329.0, 0.0, 148.0, 705.0], "M. A. Hopcroft et al., J. Microelectromech. Syst. 19 (2010) 229; CRC Handbook of Chemistry and Physics"),
    material(("fused silica", &["fused quartz", "silica", "SiO2"]), "glass of silica alone", [72.5, 0.17, 2203.0, 900.0, 1.38, 772.0], "Heraeus, data sheet of quartz glass (8.6 to 9.8 GPa)"),
    material(("soda-lime glass", &["glass", "float glass"]), "window glass; hardness after Knoop", [70.0, 0.20, 2500.0, 612.0, 1.0, 720.0], "EN 572-1"),
    // Coatings.
    material(("diamond", &[]), "polycrystal", [1143.0, 0.07, 3515.0, 0.0, 0.0, 0.0], "C. A. Klein and G. F. Cardinale, Diamond Relat. Mater. 2 (1993) 918"),
    material(("DLC", &["a-C:H"]), "hydrogenated amorphous carbon: coatings differ by a factor of two", [200.0, 0.25, 2000.0, 2000.0, 0.0, 0.0], "J. Robertson, Mater. Sci. Eng. R 37 (2002) 129: typical"),
    // Polymers and rubber, dry, at 23 degC. Their moduli fall with temperature and time under load.
    material(("PTFE", &["teflon"]), "unfilled", [0.5, 0.45, 2170.0, 0.0, 0.25, 1030.0], ASHBY),
    material(("PEEK", &[]), "unfilled", [3.9, 0.40, 1300.0, 0.0, 0.25, 1450.0], ASHBY),
    material(("UHMWPE", &["PE-UHMW"]), "of implants and liners", [0.8, 0.46, 935.0, 0.0, 0.41, 1840.0], "S. M. Kurtz, UHMWPE Biomaterials Handbook; density: ISO 5834-2; heat: Ashby"),
    material(("POM", &["acetal"]), "copolymer", [2.8, 0.38, 1410.0, 0.0, 0.31, 1470.0], ASHBY),
    material(("PA66", &["nylon", "polyamide 66"]), "dry; at 50 % humidity about half as stiff", [3.1, 0.39, 1140.0, 0.0, 0.25, 1670.0], ASHBY),
    material(("PMMA", &["acrylic"]), "unfilled", [3.1, 0.39, 1190.0, 0.0, 0.19, 1470.0], ASHBY),
    material(("rubber", &["natural rubber"]), "natural, unfilled", [0.002, 0.499, 930.0, 0.0, 0.14, 1900.0], ASHBY),
];
