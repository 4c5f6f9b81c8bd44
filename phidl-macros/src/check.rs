//! The rules over a generator, all checked, each mistake under its own token.

use syn::ext::IdentExt;
use syn::{FnArg, LitStr, Safety, Signature, Type};

use crate::model::{CHECK, Generator, Parameter};
use crate::parse::number;
use crate::problems::Problems;
use crate::unit;
use crate::widen::{last_segment, type_arguments};

/// Types that hold no number which a unit or a bound could be about.
const WITHOUT_NUMBERS: [&str; 8] = ["bool", "char", "String", "Layer", "Layers", "Port", "Device", "Partial"];

/// Checks what a generator's function cannot be.
pub(crate) fn signature(signature: &Signature, problems: &mut Problems) {
    let mut refuse = |tokens: &dyn quote::ToTokens, what: &str| {
        problems.at(tokens, format_args!("a device generator cannot be {what}"));
    };
    if let Some(token) = &signature.constness {
        refuse(token, "const, since it is drawn when it is first called");
    }
    if let Some(token) = &signature.asyncness {
        refuse(token, "async, since its callers get a finished cell");
    }
    if let Safety::Unsafe(token) = &signature.safety {
        refuse(token, "unsafe, since the registry calls it with any parameters");
    }
    if let Some(abi) = &signature.abi {
        refuse(abi, "extern");
    }
    if let Some(variadic) = &signature.variadic {
        refuse(variadic, "variadic");
    }
    if !signature.generics.params.is_empty() {
        refuse(&signature.generics, "generic, since each of its parameters is a field of one type");
    }
    if let Some(clause) = &signature.generics.where_clause {
        refuse(clause, "generic, since each of its parameters is a field of one type");
    }
    if let Some(FnArg::Receiver(receiver)) = signature.inputs.first() {
        refuse(receiver, "a method; write a function that takes what it needs as parameters");
    }
}

/// Checks what a generator says.
pub(crate) fn generator(generator: &Generator, problems: &mut Problems) {
    match &generator.output {
        None => problems.at(&generator.name, "a device generator must return `Result<Device>`"), // no tokens to mark
        Some(ty) if !is_result(ty) => problems.at(ty, "a device generator must return `Result<Device>`"),
        Some(_) => {}
    }
    for (i, param) in generator.params.iter().enumerate() {
        let registered = param.registered.value();
        if generator.params[..i].iter().any(|other| other.registered.value() == registered) {
            problems.at(&param.registered, format_args!("two parameters are named `{registered}`"));
        }
        parameter(param, problems);
    }
    if let Some(template) = &generator.options.cell_name {
        cell_name(template, &generator.params, problems);
    }
}

/// Every pair of braces in a template of names holds the registered name of a parameter.
fn cell_name(template: &LitStr, params: &[Parameter], problems: &mut Problems) {
    let text = template.value();
    let mut parts = text.split('{');
    if parts.next().is_some_and(|start| start.contains('}')) {
        problems.at(template, "a closing brace has no opening brace before it");
    }
    for part in parts {
        match part.split_once('}') {
            Some((name, rest)) if !rest.contains('}') => {
                if !params.iter().any(|param| param.registered.value() == name) {
                    let known: Vec<String> = params.iter().map(|param| param.registered.value()).collect();
                    let message =
                        format_args!("there is no parameter `{name}`; the parameters are {}", known.join(", "));
                    problems.at(template, message);
                }
            }
            _ => problems.at(template, "braces hold the name of one parameter: `{width}`"),
        }
    }
}

/// Judged by the names of types. An alias without arguments passes here; the compiler checks it.
fn is_result(ty: &Type) -> bool {
    let Some(result) = last_segment(ty).filter(|segment| segment.ident == "Result") else { return false };
    match type_arguments(result).first() {
        Some(of) => last_segment(of).is_some_and(|segment| segment.ident == "Device"),
        None => true,
    }
}

fn parameter(param: &Parameter, problems: &mut Problems) {
    if param.name.unraw() == CHECK {
        let message = "the body finds the rules of its generator under the name `check`; choose another name for the \
            parameter and register it with `#[param(name = \"check\")]`";
        problems.at(&param.name, message);
    }
    owned(&param.ty, problems);
    if let (Some(named), None) = (&param.named, &param.default) {
        problems.at(named, "a `named` parameter needs a default, since the function does not take it");
    }
    if let Some(unit) = &param.unit
        && unit::sign(&unit.value()).is_none()
    {
        problems.at(unit, format_args!("this unit is not known; the known units are {}", unit::names()));
    }
    if let Some(name) = innermost(&param.ty).filter(|name| WITHOUT_NUMBERS.contains(&name.as_str())) {
        let message = format!("`{name}` holds no number, so it can have neither a unit nor bounds");
        param.unit.iter().for_each(|unit| problems.at(unit, &message));
        param.bounds.iter().for_each(|bound| problems.at(&bound.side, &message));
    }
    bounds(param, problems);
}

/// Parameters live in the cache, so they cannot be borrowed.
fn owned(ty: &Type, problems: &mut Problems) {
    match ty {
        Type::Reference(_) => {
            problems.at(
                ty,
                "a parameter is kept with the cell and cannot be borrowed; use `String` instead of `&str` and `Vec<T>` instead of `&[T]`",
            );
        }
        Type::ImplTrait(_) => {
            problems.at(ty, "a parameter needs one type; callers can pass what converts to it in any case");
        }
        Type::Infer(_) => problems.at(ty, "a parameter needs a type"),
        Type::Group(group) => owned(&group.elem, problems),
        Type::Paren(paren) => owned(&paren.elem, problems),
        other => {
            let inner = last_segment(other).map(type_arguments).unwrap_or_default();
            inner.into_iter().for_each(|ty| owned(ty, problems));
        }
    }
}

/// The name of the type inside lists and options.
fn innermost(ty: &Type) -> Option<String> {
    let segment = last_segment(ty)?;
    match type_arguments(segment).last() {
        Some(inner) => innermost(inner),
        None => Some(segment.ident.to_string()),
    }
}

/// Bounds must leave room, and the default must keep them.
fn bounds(param: &Parameter, problems: &mut Problems) {
    for (one, other) in [("min", "above"), ("max", "below")] {
        if let (Some(_), Some(second)) = (param.bound(one), param.bounds.iter().rfind(|bound| bound.side == other)) {
            problems.at(&second.side, format_args!("`{one}` and `{other}` bound the same side; give one of them"));
        }
    }
    let low = param.bound("min").or(param.bound("above"));
    if let Some(high) = param.bounds.iter().find(|bound| bound.side == "max" || bound.side == "below")
        && low.is_some_and(|low| low > high.limit)
    {
        problems.at(&high.side, "no number is within both bounds");
    }
    if let Some(default) = &param.default
        && let Some(v) = number(default)
        && let Some(broken) = param.bounds.iter().find(|bound| !bound.holds(v))
    {
        problems.at(default, format_args!("the default breaks the bound `{} = {}`", broken.side, broken.limit));
    }
}

impl crate::model::Bound {
    fn holds(&self, v: f64) -> bool {
        match self.side.to_string().as_str() {
            "min" => v >= self.limit,
            "above" => v > self.limit,
            "max" => v <= self.limit,
            _ => v < self.limit,
        }
    }
}
