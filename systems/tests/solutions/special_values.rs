//! Compares special functions with 60-digit values, computed by mpmath 1.3: `gamma`, `digamma`,
//! `loggamma`, `ellipfun`, `ellipk`, `ellipf`, `jtheta` and `qfrom`.

use kahan_systems::special::{
    Float256, Modulus, Real, centered_digamma_difference, centered_gamma_ratio, digamma, elliptic_f,
    elliptic_k, gamma, gamma_ratio, jacobi, theta,
};

use crate::solutions::measure::{assert_close, number};

const DIGITS: i64 = 58;

fn agrees(name: &str, value: &Float256, expected: &str) {
    assert_close(value, &number(expected), DIGITS, name);
}

#[test]
fn gamma_and_digamma() {
    agrees("gamma", &gamma(&number("1/3")), "2.67893853470774763365569294097467764412868937795730110095043");
    agrees(
        "gamma",
        &gamma(&number("-17/5")),
        "0.325891160892160605390916795413459007641937814854675406017743",
    );
    agrees("gamma", &gamma(&number("123/4")), "112986461422758948361424054491668.14209990126835681622708826");
    agrees("psi", &digamma(&number("3/7")), "-2.36581875729498259721347341227211618596056046298970426960745");
    agrees(
        "psi",
        &digamma(&number("-17/5")),
        "2.38445081411801406703205313802850195204688871449806786176133",
    );
    agrees("psi", &digamma(&number("1000")), "6.90725519564881205205000611425149774547951983376888006696786");
}

#[test]
fn ratios_and_differences() {
    let ratio = gamma_ratio(&number("5/2"), &number("1/3"), &number("-2/7"));
    agrees("ratio", &ratio, "1.55298126982703765514813179400900658345009712462507114950288");
    let ratio = centered_gamma_ratio(&number("7/3"), &number("1/17"));
    agrees("w = 7/3", &ratio, "1.10577224446387665876183073816801793404786408280540434531617");
    let ratio = centered_gamma_ratio(&number("-7/3"), &number("1/17"));
    agrees("w = -7/3", &ratio, "0.564860706290610929533899168809583625709342626147427928311131");
    let ratio = centered_gamma_ratio(&number("1e20"), &number("3/7"));
    agrees("w = 1e20", &ratio, "138949549437313763.712998521735301162211304803106836367803523");
    let difference = centered_digamma_difference(&number("-7/3"), &number("1/17"));
    agrees("w = -7/3", &difference, "5.19860795874991104909652160426846001883099724597331549543664");
    let difference = centered_digamma_difference(&number("7/3"), &number("9/4"));
    agrees("w = 7/3", &difference, "3.12703792159965630852330405360062301417390830786593638084756");
}

#[test]
fn elliptic_integrals() {
    agrees(
        "K(3/5)",
        &elliptic_k(&number("3/5")),
        "1.75075380291575252897522604601214825576745916091680142664852",
    );
    agrees(
        "K(0.999999)",
        &elliptic_k(&number("0.999999")),
        "7.94747977356234476503432824810447823318916404727292462593051",
    );
    agrees(
        "F(7/5, 3/5)",
        &elliptic_f(&number("7/5"), &number("3/5")),
        "1.53783465724712677733329842138218732251984996713690618676476",
    );
    agrees(
        "F(-31/5, 3/5)",
        &elliptic_f(&number("-31/5"), &number("3/5")),
        "-6.91979537608581386343502004303356591993087366657359300773498",
    );
    agrees(
        "F(1.57, 0.999999)",
        &elliptic_f(&number("1.57"), &number("0.999999")),
        "7.41056293682897726235690224294555636903715015841089118836834",
    );
    let nome = Modulus::new(number("3/5")).nome();
    agrees("nome", &nome, "0.0278640785937287249213779028713728749877356938135849636012255");
}

#[test]
fn jacobi_functions() {
    check_jacobi(
        "7/10",
        "3/5",
        [
            "0.629917115323486810436712093960542909048645110726518986243414",
            "0.776662364108456730975251863983186593640213737900310970511024",
            "0.925825898328683245814369503576932755637650149049377017328924",
        ],
    );
    check_jacobi(
        "-53/7",
        "3/5",
        [
            "-0.529600240575509225610230765088228336018825882566134507095475",
            "0.848247360846093497386263722427603165718956207557440100177735",
            "0.948171129420027527235781540372392296125296541949287627322838",
        ],
    );
    check_jacobi(
        "3",
        "0.999999",
        [
            "0.995055236402848491708528405634858430869458115633923415788205",
            "0.0993230915108430455421736914428327885046741239023866834288824",
            "0.0993330598347204463738042656124299069126171933316745723401439",
        ],
    );
}

fn check_jacobi(u: &str, k: &str, expected: [&str; 3]) {
    let value = jacobi(&number(u), &Modulus::new(number(k)));
    for (value, expected) in [value.sn, value.cn, value.dn].iter().zip(expected) {
        agrees(u, value, expected);
    }
}

#[test]
fn theta_functions() {
    check_theta(
        "3/4",
        "1/5",
        [
            "0.870003391730971558951485936820488800491243391529093402568726",
            "0.944942636976721096330779648626462479858982316626035174953136",
            "1.02512668883564626776100177611563726724180661465299208001183",
            "0.968537359211281169274827262557495267822953286691206614687932",
        ],
    );
    check_theta(
        "-13/2",
        "9/10",
        [
            "-0.000000151543949602272650118687063560284586164720161580184579695299",
            "3.49516107938877775944763349772281886424800294036038996182386",
            "3.49516107938877775944763349772281892415267234985296906725454",
            "0.000000151544684527741196580493168438015453961857337603269415926532",
        ],
    );
}

fn check_theta(z: &str, q: &str, expected: [&str; 4]) {
    let value = theta(&number(z), &number(q));
    for (value, expected) in [value.one, value.two, value.three, value.four].iter().zip(expected) {
        // The absolute error is tested, because the relative error is large near a zero of a theta
        // function.
        let error = (*value - number(expected)).abs();
        assert!(error < Float256::from_int(10).power(-DIGITS), "{value} where {expected} is expected");
    }
}
