"use strict";(()=>{function Bm(i,e,t){for(let[n,s]of Object.entries(e))typeof s=="function"?i.addEventListener(n,s):s!=null&&s!==!1&&i.setAttribute(n,s===!0?"":String(s));return i.append(...t.filter(n=>n!=null&&n!==!1)),i}var M=(i,e={},...t)=>Bm(document.createElement(i),e,t),ie=(i,e={},...t)=>Bm(document.createElementNS("http://www.w3.org/2000/svg",i),e,t);function ze(i,e){i.textContent!==e&&(i.textContent=e)}var Fm=new WeakMap;function jn(i,e){let[t,n]=[Fm.get(i),JSON.stringify(e)];return Fm.set(i,n),t!==n}var or=i=>M("ul",{class:"w-sentences"},...i.map(e=>M("li",{},String(e)))),Mi=(i,e,t="")=>M("table",{},t&&M("caption",{},t),M("thead",{},M("tr",{},...i.map(n=>M("th",{scope:"col"},n)))),M("tbody",{},...e)),Rl=(i,e)=>M("tr",{},M("th",{scope:"row"},i),...e.map(t=>M("td",{},t))),ar=(i,e=null)=>M("ul",{"aria-label":e},...i.map(({colour:t,label:n})=>M("li",{},M("i",{"aria-hidden":"true",style:`background:var(--${t})`}),n))),Zt=(i,e,t,n="start",s={})=>ie("text",{x:i,y:e,"text-anchor":n,fill:"var(--ink)","font-size":11.5,...s},t),ib="\u2212",Be=(i,e)=>{let n=(Math.abs(i*2**(e+1)%2)===1?2*Math.round(i*10**e/2)/10**e:i).toFixed(e);return/^-0(\.0*)?$/.test(n)?n.slice(1):n.replace("-",ib)};function Cl(i){let e=new Map;for(let t of i)e.set(t,(e.get(t)??0)+1);return[...e].map(([t,n])=>`${n}\xA0\xD7\xA0${t}`).join(", ")}var Yi=i=>i.charAt(0).toUpperCase()+i.slice(1),Rs=i=>i==="transfer"?"free motion":i,_e=(i,e=0)=>`${Be(100*i,e)}\u202F%`,Gt=({mean:i,low:e,high:t},n=0,s=_e(i,n))=>`${s} (90\u202F%: ${_e(e,n)} to ${_e(t,n)})`,wn="\u2013",rn=(i,e)=>typeof i=="number"?e(i):wn;function Je(i,e=1){let t=Be(i,e),n=Number(t);if(!(n>=60))return`${t} s`;let[s,r]=[Math.floor(n/3600),Math.floor(n/60)%60],o=(n%60).toFixed(e).padStart(e?e+3:2,"0");return s?`${s}:${String(r).padStart(2,"0")}:${o}`:`${r}:${o}`}var sb=0,ai=()=>`w${++sb}`;var Po=class{data=[];least=1/0;largest=-1/0;push(e){this.data.push(e),e<this.least&&(this.least=e),e>this.largest&&(this.largest=e)}range(e,t){let[n,s]=[1/0,-1/0];for(let r=Math.max(0,e),o=Math.min(t,this.data.length);r<o;r++){let a=this.data[r];a<n&&(n=a),a>s&&(s=a)}return n<=s?[n,s]:null}};function Io(i,e){let[t,n]=[0,i];for(;t<n;){let s=t+n>>1;e(s)?t=s+1:n=s}return t-1}var li=(i,e)=>Io(i.length,t=>i[t]<=e),ci=i=>typeof i=="number"?i:NaN;var Lo=1e4,Pl=32,lt=i=>Float32Array.from(i,e=>ci(e)/Lo),Do=(i,{place:[e,t],radius:n})=>i.filter((s,r)=>r%2===0&&Math.hypot(s-e,i[r+1]-t)<=n).length,Il=class{constructor(e,t,n){this.steps=e;this.now=t;this.apply=n;this.times=e.map(([s])=>ci(s)),e.reduce((s,r,o)=>{let a=n(s,r);return o%Pl===0&&this.snapshots.push(a),a},t)}steps;now;apply;times;snapshots=[];index=-1;at(e){let t=Math.min(this.steps.length-1,Math.max(0,li(this.times,e)));if(t===this.index)return this.now;let n=Math.floor(t/Pl);for(this.index<t&&this.index>=n*Pl||(this.index=n*Pl,this.now=this.snapshots[n]);this.index<t;)this.now=this.apply(this.now,this.steps[++this.index]);return this.now}get first(){return this.at(-1/0)}get last(){return this.at(1/0)}},zm=i=>new Il(i,new Float32Array,rb),Vm=({steps:i,step:e,places:t})=>new Il(i,Array.from({length:t.length/2},()=>0),(n,[,s,r])=>{let o=[...n];return s.forEach((a,l)=>{a<o.length&&(o[a]=ci(r[l])*e)}),o});function rb(i,[,e,t]){let n=new Set(e),s=i.filter((o,a)=>!n.has(a>>1)),r=new Float32Array(s.length+t.length);return r.set(s),r.set(lt(t),s.length),r}/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */var as={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},ls={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Dg=0,lf=1,Ng=2;var Gs=1,kg=2,Yr=3,cs=0,xn=1,hn=2,Hs=0,Zr=1,cf=2,hf=3,uf=4,Og=5;var Ws=100,Ug=101,Fg=102,Bg=103,zg=104,Vg=200,Gg=201,Hg=202,Wg=203,df=204,ff=205,$g=206,Xg=207,qg=208,Yg=209,Zg=210,jg=211,Kg=212,Jg=213,Qg=214,pc=0,mc=1,gc=2,Ir=3,xc=4,yc=5,vc=6,bc=7,Oa=0,e0=1,t0=2,pi=0,pf=1,mf=2,gf=3,xf=4,yf=5,vf=6,bf=7;var _f=300,$s=301,jr=302,Kc=303,Jc=304,Lr=1e3,di=1001,_c=1002,Wt=1003,n0=1004;var Ua=1005;var mn=1006,Qc=1007;var Ni=1008;var Tn=1009,wf=1010,Mf=1011,Kr=1012,eh=1013,ni=1014,Xn=1015,ii=1016,th=1017,nh=1018,Xs=1020,Sf=35902,Tf=35899,Ef=1021,Af=1022,si=1023,Pi=1026,ki=1027,ih=1028,sh=1029,hs=1030,rh=1031;var oh=1033,Fa=33776,Ba=33777,za=33778,Va=33779,ah=35840,lh=35841,ch=35842,hh=35843,uh=36196,dh=37492,fh=37496,ph=37488,mh=37489,Ga=37490,gh=37491,xh=37808,yh=37809,vh=37810,bh=37811,_h=37812,wh=37813,Mh=37814,Sh=37815,Th=37816,Eh=37817,Ah=37818,Rh=37819,Ch=37820,Ph=37821,Ih=36492,Lh=36494,Dh=36495,Nh=36283,kh=36284,Ha=36285,Oh=36286;var Zo=2300,wc=2301,dc=2302,jd=2303,Kd=2400,Jd=2401,Qd=2402;var i0=3200;var Jr=0,s0=1,Oi="",jt="srgb",jo="srgb-linear",Ko="linear",dt="srgb";var fc=7680,Rf=7681;var Cf=517;var r0=519,o0=512,a0=513,l0=514,Pf=515,c0=516,h0=517,If=518,Lf=519,Df=35044;var Nf="300 es",Wn=2e3,Dr=2001;function ob(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function ab(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function Jo(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function u0(){let i=Jo("canvas");return i.style.display="block",i}var Gm={},Nr=null;function Qo(...i){let e="THREE."+i.shift();Nr?Nr("log",e,...i):console.log(e,...i)}function d0(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function De(...i){i=d0(i);let e="THREE."+i.shift();if(Nr)Nr("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function Ve(...i){i=d0(i);let e="THREE."+i.shift();if(Nr)Nr("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function $o(...i){let e=i.join(" ");e in Gm||(Gm[e]=!0,De(...i))}function f0(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var p0={[pc]:pc,[gc]:vc,[xc]:xc,[Ir]:yc,[mc]:mc,[vc]:gc,[bc]:bc,[yc]:Ir},ei=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},on=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Hm=1234567,Rr=Math.PI/180,kr=180/Math.PI;function Ui(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(on[i&255]+on[i>>8&255]+on[i>>16&255]+on[i>>24&255]+"-"+on[e&255]+on[e>>8&255]+"-"+on[e>>16&15|64]+on[e>>24&255]+"-"+on[t&63|128]+on[t>>8&255]+"-"+on[t>>16&255]+on[t>>24&255]+on[n&255]+on[n>>8&255]+on[n>>16&255]+on[n>>24&255]).toLowerCase()}function Ge(i,e,t){return Math.max(e,Math.min(t,i))}function kf(i,e){return(i%e+e)%e}function lb(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function cb(i,e,t){return i!==e?(t-i)/(e-i):0}function Xo(i,e,t){return(1-t)*i+t*e}function hb(i,e,t,n){return Xo(i,e,1-Math.exp(-t*n))}function ub(i,e=1){return e-Math.abs(kf(i,e*2)-e)}function db(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function fb(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function pb(i,e){return i+Math.floor(Math.random()*(e-i+1))}function mb(i,e){return i+Math.random()*(e-i)}function gb(i){return i*(.5-Math.random())}function xb(i){i!==void 0&&(Hm=i);let e=Hm+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function yb(i){return i*Rr}function vb(i){return i*kr}function bb(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function _b(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function Of(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function wb(i,e,t,n,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+n)/2),h=o((e+n)/2),u=r((e-n)/2),d=o((e-n)/2),f=r((n-e)/2),p=o((n-e)/2);switch(s){case"XYX":i.set(a*h,l*u,l*d,a*c);break;case"YZY":i.set(l*d,a*h,l*u,a*c);break;case"ZXZ":i.set(l*u,l*d,a*h,a*c);break;case"XZX":i.set(a*h,l*p,l*f,a*c);break;case"YXY":i.set(l*f,a*h,l*p,a*c);break;case"ZYZ":i.set(l*p,l*f,a*h,a*c);break;default:De("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Uh(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Uf(i,e){if(e.constructor===Float32Array)return i;let t=Uh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function Ff(i,e){if(e.constructor===Float32Array)return i;let t=Uh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var Qr={DEG2RAD:Rr,RAD2DEG:kr,generateUUID:Ui,clamp:Ge,euclideanModulo:kf,mapLinear:lb,inverseLerp:cb,lerp:Xo,damp:hb,pingpong:ub,smoothstep:db,smootherstep:fb,randInt:pb,randFloat:mb,randFloatSpread:gb,seededRandom:xb,degToRad:yb,radToDeg:vb,isPowerOfTwo:bb,ceilPowerOfTwo:_b,floorPowerOfTwo:Of,setQuaternionFromProperEuler:wb,normalize:Ff,denormalize:Uf},te=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=Ge(this.x,e.x,t.x),this.y=Ge(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=Ge(this.x,e,t),this.y=Ge(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Ge(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(Ge(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Rt=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3],d=r[o+0],f=r[o+1],p=r[o+2],x=r[o+3];if(u!==x||l!==d||c!==f||h!==p){let g=l*d+c*f+h*p+u*x;g<0&&(d=-d,f=-f,p=-p,x=-x,g=-g);let m=1-a;if(g<.9995){let y=Math.acos(g),S=Math.sin(y);m=Math.sin(m*y)/S,a=Math.sin(a*y)/S,l=l*m+d*a,c=c*m+f*a,h=h*m+p*a,u=u*m+x*a}else{l=l*m+d*a,c=c*m+f*a,h=h*m+p*a,u=u*m+x*a;let y=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=y,c*=y,h*=y,u*=y}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=u}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[o],d=r[o+1],f=r[o+2],p=r[o+3];return e[t]=a*p+h*u+l*f-c*d,e[t+1]=l*p+h*d+c*u-a*f,e[t+2]=c*p+h*f+a*d-l*u,e[t+3]=h*p-a*u-l*d-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(r/2),d=l(n/2),f=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=d*h*u+c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u-d*f*p;break;case"YXZ":this._x=d*h*u+c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u+d*f*p;break;case"ZXY":this._x=d*h*u-c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u-d*f*p;break;case"ZYX":this._x=d*h*u-c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u+d*f*p;break;case"YZX":this._x=d*h*u+c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u-d*f*p;break;case"XZY":this._x=d*h*u-c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u+d*f*p;break;default:De("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],h=t[6],u=t[10],d=n+a+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(n>a&&n>u){let f=2*Math.sqrt(1+n-a-u);this._w=(h-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>u){let f=2*Math.sqrt(1+a-n-u);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+u-n-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(Ge(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,h=t._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},E=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Wm.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Wm.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),h=2*(a*t-r*s),u=2*(r*n-o*t);return this.x=t+l*c+o*u-a*h,this.y=n+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=Ge(this.x,e.x,t.x),this.y=Ge(this.y,e.y,t.y),this.z=Ge(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=Ge(this.x,e,t),this.y=Ge(this.y,e,t),this.z=Ge(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Ge(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return Md.copy(this).projectOnVector(e),this.sub(Md)}reflect(e){return this.sub(Md.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(Ge(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Md=new E,Wm=new Rt,He=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){let h=this.elements;return h[0]=e,h[1]=s,h[2]=a,h[3]=t,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],d=n[2],f=n[5],p=n[8],x=s[0],g=s[3],m=s[6],y=s[1],S=s[4],b=s[7],A=s[2],R=s[5],v=s[8];return r[0]=o*x+a*y+l*A,r[3]=o*g+a*S+l*R,r[6]=o*m+a*b+l*v,r[1]=c*x+h*y+u*A,r[4]=c*g+h*S+u*R,r[7]=c*m+h*b+u*v,r[2]=d*x+f*y+p*A,r[5]=d*g+f*S+p*R,r[8]=d*m+f*b+p*v,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8];return t*o*h-t*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=h*o-a*c,d=a*l-h*r,f=c*r-o*l,p=t*u+n*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/p;return e[0]=u*x,e[1]=(s*c-h*n)*x,e[2]=(a*n-s*o)*x,e[3]=d*x,e[4]=(h*t-s*l)*x,e[5]=(s*r-a*t)*x,e[6]=f*x,e[7]=(n*l-c*t)*x,e[8]=(o*t-n*r)*x,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return $o("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Sd.makeScale(e,t)),this}rotate(e){return $o("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Sd.makeRotation(-e)),this}translate(e,t){return $o("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Sd.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Sd=new He,$m=new He().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Xm=new He().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Mb(){let i={enabled:!0,workingColorSpace:jo,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===dt&&(s.r=Ci(s.r),s.g=Ci(s.g),s.b=Ci(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===dt&&(s.r=Cr(s.r),s.g=Cr(s.g),s.b=Cr(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Oi?Ko:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[jo]:{primaries:e,whitePoint:n,transfer:Ko,toXYZ:$m,fromXYZ:Xm,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:jt},outputColorSpaceConfig:{drawingBufferColorSpace:jt}},[jt]:{primaries:e,whitePoint:n,transfer:dt,toXYZ:$m,fromXYZ:Xm,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:jt}}}),i}var it=Mb();function Ci(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Cr(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var lr,Mc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{lr===void 0&&(lr=Jo("canvas")),lr.width=e.width,lr.height=e.height;let s=lr.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=lr}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Jo("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Ci(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(Ci(t[n]/255)*255):t[n]=Ci(t[n]);return{data:t,width:e.width,height:e.height}}else return De("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},Sb=0,Or=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Sb++}),this.uuid=Ui(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Td(s[o].image)):r.push(Td(s[o]))}else r=Td(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function Td(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Mc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(De("Texture: Unable to serialize Texture."),{})}var Tb=0,Ed=new E,gn=class i extends ei{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=di,s=di,r=mn,o=Ni,a=si,l=Tn,c=i.DEFAULT_ANISOTROPY,h=Oi){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Tb++}),this.uuid=Ui(),this.name="",this.source=new Or(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new te(0,0),this.repeat=new te(1,1),this.center=new te(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new He,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Ed).x}get height(){return this.source.getSize(Ed).y}get depth(){return this.source.getSize(Ed).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){De(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){De(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==_f)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Lr:e.x=e.x-Math.floor(e.x);break;case di:e.x=e.x<0?0:1;break;case _c:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Lr:e.y=e.y-Math.floor(e.y);break;case di:e.y=e.y<0?0:1;break;case _c:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};gn.DEFAULT_IMAGE=null;gn.DEFAULT_MAPPING=_f;gn.DEFAULT_ANISOTROPY=1;var ft=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],h=l[4],u=l[8],d=l[1],f=l[5],p=l[9],x=l[2],g=l[6],m=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-x)<.01&&Math.abs(p-g)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+x)<.1&&Math.abs(p+g)<.1&&Math.abs(c+f+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let S=(c+1)/2,b=(f+1)/2,A=(m+1)/2,R=(h+d)/4,v=(u+x)/4,T=(p+g)/4;return S>b&&S>A?S<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(S),s=R/n,r=v/n):b>A?b<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),n=R/s,r=T/s):A<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(A),n=v/r,s=T/r),this.set(n,s,r,t),this}let y=Math.sqrt((g-p)*(g-p)+(u-x)*(u-x)+(d-h)*(d-h));return Math.abs(y)<.001&&(y=1),this.x=(g-p)/y,this.y=(u-x)/y,this.z=(d-h)/y,this.w=Math.acos((c+f+m-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=Ge(this.x,e.x,t.x),this.y=Ge(this.y,e.y,t.y),this.z=Ge(this.z,e.z,t.z),this.w=Ge(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=Ge(this.x,e,t),this.y=Ge(this.y,e,t),this.z=Ge(this.z,e,t),this.w=Ge(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Ge(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Sc=class extends ei{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:mn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new ft(0,0,e,t),this.scissorTest=!1,this.viewport=new ft(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new gn({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:mn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Or(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Dn=class extends Sc{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},ea=class extends gn{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Wt,this.minFilter=Wt,this.wrapR=di,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Tc=class extends gn{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Wt,this.minFilter=Wt,this.wrapR=di,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Le=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,o,a,l,c,h,u,d,f,p,x,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,h,u,d,f,p,x,g)}set(e,t,n,s,r,o,a,l,c,h,u,d,f,p,x,g){let m=this.elements;return m[0]=e,m[4]=t,m[8]=n,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=h,m[10]=u,m[14]=d,m[3]=f,m[7]=p,m[11]=x,m[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/cr.setFromMatrixColumn(e,0).length(),r=1/cr.setFromMatrixColumn(e,1).length(),o=1/cr.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(e.order==="XYZ"){let d=o*h,f=o*u,p=a*h,x=a*u;t[0]=l*h,t[4]=-l*u,t[8]=c,t[1]=f+p*c,t[5]=d-x*c,t[9]=-a*l,t[2]=x-d*c,t[6]=p+f*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*h,f=l*u,p=c*h,x=c*u;t[0]=d+x*a,t[4]=p*a-f,t[8]=o*c,t[1]=o*u,t[5]=o*h,t[9]=-a,t[2]=f*a-p,t[6]=x+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*h,f=l*u,p=c*h,x=c*u;t[0]=d-x*a,t[4]=-o*u,t[8]=p+f*a,t[1]=f+p*a,t[5]=o*h,t[9]=x-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*h,f=o*u,p=a*h,x=a*u;t[0]=l*h,t[4]=p*c-f,t[8]=d*c+x,t[1]=l*u,t[5]=x*c+d,t[9]=f*c-p,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,f=o*c,p=a*l,x=a*c;t[0]=l*h,t[4]=x-d*u,t[8]=p*u+f,t[1]=u,t[5]=o*h,t[9]=-a*h,t[2]=-c*h,t[6]=f*u+p,t[10]=d-x*u}else if(e.order==="XZY"){let d=o*l,f=o*c,p=a*l,x=a*c;t[0]=l*h,t[4]=-u,t[8]=c*h,t[1]=d*u+x,t[5]=o*h,t[9]=f*u-p,t[2]=p*u-f,t[6]=a*h,t[10]=x*u+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(Eb,e,Ab)}lookAt(e,t,n){let s=this.elements;return Pn.subVectors(e,t),Pn.lengthSq()===0&&(Pn.z=1),Pn.normalize(),Zi.crossVectors(n,Pn),Zi.lengthSq()===0&&(Math.abs(n.z)===1?Pn.x+=1e-4:Pn.z+=1e-4,Pn.normalize(),Zi.crossVectors(n,Pn)),Zi.normalize(),Ll.crossVectors(Pn,Zi),s[0]=Zi.x,s[4]=Ll.x,s[8]=Pn.x,s[1]=Zi.y,s[5]=Ll.y,s[9]=Pn.y,s[2]=Zi.z,s[6]=Ll.z,s[10]=Pn.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],d=n[9],f=n[13],p=n[2],x=n[6],g=n[10],m=n[14],y=n[3],S=n[7],b=n[11],A=n[15],R=s[0],v=s[4],T=s[8],D=s[12],P=s[1],k=s[5],O=s[9],z=s[13],I=s[2],H=s[6],X=s[10],G=s[14],ne=s[3],$=s[7],J=s[11],ee=s[15];return r[0]=o*R+a*P+l*I+c*ne,r[4]=o*v+a*k+l*H+c*$,r[8]=o*T+a*O+l*X+c*J,r[12]=o*D+a*z+l*G+c*ee,r[1]=h*R+u*P+d*I+f*ne,r[5]=h*v+u*k+d*H+f*$,r[9]=h*T+u*O+d*X+f*J,r[13]=h*D+u*z+d*G+f*ee,r[2]=p*R+x*P+g*I+m*ne,r[6]=p*v+x*k+g*H+m*$,r[10]=p*T+x*O+g*X+m*J,r[14]=p*D+x*z+g*G+m*ee,r[3]=y*R+S*P+b*I+A*ne,r[7]=y*v+S*k+b*H+A*$,r[11]=y*T+S*O+b*X+A*J,r[15]=y*D+S*z+b*G+A*ee,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],h=e[2],u=e[6],d=e[10],f=e[14],p=e[3],x=e[7],g=e[11],m=e[15],y=l*f-c*d,S=a*f-c*u,b=a*d-l*u,A=o*f-c*h,R=o*d-l*h,v=o*u-a*h;return t*(x*y-g*S+m*b)-n*(p*y-g*A+m*R)+s*(p*S-x*A+m*v)-r*(p*b-x*R+g*v)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],h=e[10];return t*(o*h-a*c)-n*(r*h-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=e[9],d=e[10],f=e[11],p=e[12],x=e[13],g=e[14],m=e[15],y=t*a-n*o,S=t*l-s*o,b=t*c-r*o,A=n*l-s*a,R=n*c-r*a,v=s*c-r*l,T=h*x-u*p,D=h*g-d*p,P=h*m-f*p,k=u*g-d*x,O=u*m-f*x,z=d*m-f*g,I=y*z-S*O+b*k+A*P-R*D+v*T;if(I===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let H=1/I;return e[0]=(a*z-l*O+c*k)*H,e[1]=(s*O-n*z-r*k)*H,e[2]=(x*v-g*R+m*A)*H,e[3]=(d*R-u*v-f*A)*H,e[4]=(l*P-o*z-c*D)*H,e[5]=(t*z-s*P+r*D)*H,e[6]=(g*b-p*v-m*S)*H,e[7]=(h*v-d*b+f*S)*H,e[8]=(o*O-a*P+c*T)*H,e[9]=(n*P-t*O-r*T)*H,e[10]=(p*R-x*b+m*y)*H,e[11]=(u*b-h*R-f*y)*H,e[12]=(a*D-o*k-l*T)*H,e[13]=(t*k-n*D+s*T)*H,e[14]=(x*S-p*A-g*y)*H,e[15]=(h*A-u*S+d*y)*H,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,h=o+o,u=a+a,d=r*c,f=r*h,p=r*u,x=o*h,g=o*u,m=a*u,y=l*c,S=l*h,b=l*u,A=n.x,R=n.y,v=n.z;return s[0]=(1-(x+m))*A,s[1]=(f+b)*A,s[2]=(p-S)*A,s[3]=0,s[4]=(f-b)*R,s[5]=(1-(d+m))*R,s[6]=(g+y)*R,s[7]=0,s[8]=(p+S)*v,s[9]=(g-y)*v,s[10]=(1-(d+x))*v,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let o=cr.set(s[0],s[1],s[2]).length(),a=cr.set(s[4],s[5],s[6]).length(),l=cr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Kn.copy(this);let c=1/o,h=1/a,u=1/l;return Kn.elements[0]*=c,Kn.elements[1]*=c,Kn.elements[2]*=c,Kn.elements[4]*=h,Kn.elements[5]*=h,Kn.elements[6]*=h,Kn.elements[8]*=u,Kn.elements[9]*=u,Kn.elements[10]*=u,t.setFromRotationMatrix(Kn),n.x=o,n.y=a,n.z=l,this}makePerspective(e,t,n,s,r,o,a=Wn,l=!1){let c=this.elements,h=2*r/(t-e),u=2*r/(n-s),d=(t+e)/(t-e),f=(n+s)/(n-s),p,x;if(l)p=r/(o-r),x=o*r/(o-r);else if(a===Wn)p=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===Dr)p=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=Wn,l=!1){let c=this.elements,h=2/(t-e),u=2/(n-s),d=-(t+e)/(t-e),f=-(n+s)/(n-s),p,x;if(l)p=1/(o-r),x=o/(o-r);else if(a===Wn)p=-2/(o-r),x=-(o+r)/(o-r);else if(a===Dr)p=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},cr=new E,Kn=new Le,Eb=new E(0,0,0),Ab=new E(1,1,1),Zi=new E,Ll=new E,Pn=new E,qm=new Le,Ym=new Rt,ti=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(Ge(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Ge(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(Ge(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-Ge(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(Ge(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-Ge(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:De("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return qm.makeRotationFromQuaternion(e),this.setFromRotationMatrix(qm,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Ym.setFromEuler(this),this.setFromQuaternion(Ym,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};ti.DEFAULT_ORDER="XYZ";var ta=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},Rb=0,Zm=new E,hr=new Rt,Si=new Le,Dl=new E,No=new E,Cb=new E,Pb=new Rt,jm=new E(1,0,0),Km=new E(0,1,0),Jm=new E(0,0,1),Qm={type:"added"},Ib={type:"removed"},ur={type:"childadded",child:null},Ad={type:"childremoved",child:null},Nt=class i extends ei{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Rb++}),this.uuid=Ui(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new E,t=new ti,n=new Rt,s=new E(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Le},normalMatrix:{value:new He}}),this.matrix=new Le,this.matrixWorld=new Le,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ta,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return hr.setFromAxisAngle(e,t),this.quaternion.multiply(hr),this}rotateOnWorldAxis(e,t){return hr.setFromAxisAngle(e,t),this.quaternion.premultiply(hr),this}rotateX(e){return this.rotateOnAxis(jm,e)}rotateY(e){return this.rotateOnAxis(Km,e)}rotateZ(e){return this.rotateOnAxis(Jm,e)}translateOnAxis(e,t){return Zm.copy(e).applyQuaternion(this.quaternion),this.position.add(Zm.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(jm,e)}translateY(e){return this.translateOnAxis(Km,e)}translateZ(e){return this.translateOnAxis(Jm,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Si.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?Dl.copy(e):Dl.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),No.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Si.lookAt(No,Dl,this.up):Si.lookAt(Dl,No,this.up),this.quaternion.setFromRotationMatrix(Si),s&&(Si.extractRotation(s.matrixWorld),hr.setFromRotationMatrix(Si),this.quaternion.premultiply(hr.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(Ve("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Qm),ur.child=e,this.dispatchEvent(ur),ur.child=null):Ve("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(Ib),Ad.child=e,this.dispatchEvent(Ad),Ad.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Si.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Si.multiply(e.parent.matrixWorld)),e.applyMatrix4(Si),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Qm),ur.child=e,this.dispatchEvent(ur),ur.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(No,e,Cb),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(No,Pb,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(e.shapes,u)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),h=o(e.images),u=o(e.shapes),d=o(e.skeletons),f=o(e.animations),p=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),p.length>0&&(n.nodes=p)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Nt.DEFAULT_UP=new E(0,1,0);Nt.DEFAULT_MATRIX_AUTO_UPDATE=!0;Nt.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var ot=class extends Nt{constructor(){super(),this.isGroup=!0,this.type="Group"}},Lb={type:"move"},Ur=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new ot,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new ot,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new E,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new E),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new ot,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new E,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new E,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let x of e.hand.values()){let g=t.getJointPose(x,n),m=this._getHandJoint(c,x);g!==null&&(m.matrix.fromArray(g.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=g.radius),m.visible=g!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,p=.005;c.inputState.pinching&&d>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Lb)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new ot;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},m0={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},ji={h:0,s:0,l:0},Nl={h:0,s:0,l:0};function Rd(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var Re=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=jt){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,it.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=it.workingColorSpace){return this.r=e,this.g=t,this.b=n,it.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=it.workingColorSpace){if(e=kf(e,1),t=Ge(t,0,1),n=Ge(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=Rd(o,r,e+1/3),this.g=Rd(o,r,e),this.b=Rd(o,r,e-1/3)}return it.colorSpaceToWorking(this,s),this}setStyle(e,t=jt){function n(r){r!==void 0&&parseFloat(r)<1&&De("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:De("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);De("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=jt){let n=m0[e.toLowerCase()];return n!==void 0?this.setHex(n,t):De("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Ci(e.r),this.g=Ci(e.g),this.b=Ci(e.b),this}copyLinearToSRGB(e){return this.r=Cr(e.r),this.g=Cr(e.g),this.b=Cr(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=jt){return it.workingToColorSpace(an.copy(this),e),Math.round(Ge(an.r*255,0,255))*65536+Math.round(Ge(an.g*255,0,255))*256+Math.round(Ge(an.b*255,0,255))}getHexString(e=jt){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=it.workingColorSpace){it.workingToColorSpace(an.copy(this),t);let n=an.r,s=an.g,r=an.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=it.workingColorSpace){return it.workingToColorSpace(an.copy(this),t),e.r=an.r,e.g=an.g,e.b=an.b,e}getStyle(e=jt){it.workingToColorSpace(an.copy(this),e);let t=an.r,n=an.g,s=an.b;return e!==jt?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(ji),this.setHSL(ji.h+e,ji.s+t,ji.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(ji),e.getHSL(Nl);let n=Xo(ji.h,Nl.h,t),s=Xo(ji.s,Nl.s,t),r=Xo(ji.l,Nl.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},an=new Re;Re.NAMES=m0;var na=class extends Nt{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ti,this.environmentIntensity=1,this.environmentRotation=new ti,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Jn=new E,Ti=new E,Cd=new E,Ei=new E,dr=new E,fr=new E,eg=new E,Pd=new E,Id=new E,Ld=new E,Dd=new ft,Nd=new ft,kd=new ft,ui=class i{constructor(e=new E,t=new E,n=new E){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),Jn.subVectors(e,t),s.cross(Jn);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){Jn.subVectors(s,t),Ti.subVectors(n,t),Cd.subVectors(e,t);let o=Jn.dot(Jn),a=Jn.dot(Ti),l=Jn.dot(Cd),c=Ti.dot(Ti),h=Ti.dot(Cd),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(c*l-a*h)*d,p=(o*h-a*l)*d;return r.set(1-f-p,p,f)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,Ei)===null?!1:Ei.x>=0&&Ei.y>=0&&Ei.x+Ei.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,Ei)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Ei.x),l.addScaledVector(o,Ei.y),l.addScaledVector(a,Ei.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return Dd.setScalar(0),Nd.setScalar(0),kd.setScalar(0),Dd.fromBufferAttribute(e,t),Nd.fromBufferAttribute(e,n),kd.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Dd,r.x),o.addScaledVector(Nd,r.y),o.addScaledVector(kd,r.z),o}static isFrontFacing(e,t,n,s){return Jn.subVectors(n,t),Ti.subVectors(e,t),Jn.cross(Ti).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Jn.subVectors(this.c,this.b),Ti.subVectors(this.a,this.b),Jn.cross(Ti).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;dr.subVectors(s,n),fr.subVectors(r,n),Pd.subVectors(e,n);let l=dr.dot(Pd),c=fr.dot(Pd);if(l<=0&&c<=0)return t.copy(n);Id.subVectors(e,s);let h=dr.dot(Id),u=fr.dot(Id);if(h>=0&&u<=h)return t.copy(s);let d=l*u-h*c;if(d<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),t.copy(n).addScaledVector(dr,o);Ld.subVectors(e,r);let f=dr.dot(Ld),p=fr.dot(Ld);if(p>=0&&f<=p)return t.copy(r);let x=f*c-l*p;if(x<=0&&c>=0&&p<=0)return a=c/(c-p),t.copy(n).addScaledVector(fr,a);let g=h*p-f*u;if(g<=0&&u-h>=0&&f-p>=0)return eg.subVectors(r,s),a=(u-h)/(u-h+(f-p)),t.copy(s).addScaledVector(eg,a);let m=1/(g+x+d);return o=x*m,a=d*m,t.copy(n).addScaledVector(dr,o).addScaledVector(fr,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},kt=class{constructor(e=new E(1/0,1/0,1/0),t=new E(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(Qn.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(Qn.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Qn.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Qn):Qn.fromBufferAttribute(r,o),Qn.applyMatrix4(e.matrixWorld),this.expandByPoint(Qn);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),kl.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),kl.copy(n.boundingBox)),kl.applyMatrix4(e.matrixWorld),this.union(kl)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Qn),Qn.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(ko),Ol.subVectors(this.max,ko),pr.subVectors(e.a,ko),mr.subVectors(e.b,ko),gr.subVectors(e.c,ko),Ki.subVectors(mr,pr),Ji.subVectors(gr,mr),Cs.subVectors(pr,gr);let t=[0,-Ki.z,Ki.y,0,-Ji.z,Ji.y,0,-Cs.z,Cs.y,Ki.z,0,-Ki.x,Ji.z,0,-Ji.x,Cs.z,0,-Cs.x,-Ki.y,Ki.x,0,-Ji.y,Ji.x,0,-Cs.y,Cs.x,0];return!Od(t,pr,mr,gr,Ol)||(t=[1,0,0,0,1,0,0,0,1],!Od(t,pr,mr,gr,Ol))?!1:(Ul.crossVectors(Ki,Ji),t=[Ul.x,Ul.y,Ul.z],Od(t,pr,mr,gr,Ol))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Qn).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Qn).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Ai[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Ai[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Ai[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Ai[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Ai[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Ai[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Ai[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Ai[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Ai),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Ai=[new E,new E,new E,new E,new E,new E,new E,new E],Qn=new E,kl=new kt,pr=new E,mr=new E,gr=new E,Ki=new E,Ji=new E,Cs=new E,ko=new E,Ol=new E,Ul=new E,Ps=new E;function Od(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){Ps.fromArray(i,r);let a=s.x*Math.abs(Ps.x)+s.y*Math.abs(Ps.y)+s.z*Math.abs(Ps.z),l=e.dot(Ps),c=t.dot(Ps),h=n.dot(Ps);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var It=new E,Fl=new te,Db=0,ct=class extends ei{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Db++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=Df,this.updateRanges=[],this.gpuType=Xn,this.version=0,this._normalizationScale=e!==void 0?Uh(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)Fl.fromBufferAttribute(this,t),Fl.applyMatrix3(e),this.setXY(t,Fl.x,Fl.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)It.fromBufferAttribute(this,t),It.applyMatrix3(e),this.setXYZ(t,It.x,It.y,It.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)It.fromBufferAttribute(this,t),It.applyMatrix4(e),this.setXYZ(t,It.x,It.y,It.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)It.fromBufferAttribute(this,t),It.applyNormalMatrix(e),this.setXYZ(t,It.x,It.y,It.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)It.fromBufferAttribute(this,t),It.transformDirection(e),this.setXYZ(t,It.x,It.y,It.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Uf(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Ff(e,this.array)}};var ia=class extends ct{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var sa=class extends ct{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var Ne=class extends ct{constructor(e,t,n){super(new Float32Array(e),t,n)}},Nb=new kt,Oo=new E,Ud=new E,ln=class{constructor(e=new E,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):Nb.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Oo.subVectors(e,this.center);let t=Oo.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(Oo,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Ud.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Oo.copy(e.center).add(Ud)),this.expandByPoint(Oo.copy(e.center).sub(Ud))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},kb=0,Hn=new Le,Fd=new Nt,xr=new E,In=new kt,Uo=new kt,Ht=new E,We=class i extends ei{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:kb++}),this.uuid=Ui(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(ob(e)?sa:ia)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new He().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Hn.makeRotationFromQuaternion(e),this.applyMatrix4(Hn),this}rotateX(e){return Hn.makeRotationX(e),this.applyMatrix4(Hn),this}rotateY(e){return Hn.makeRotationY(e),this.applyMatrix4(Hn),this}rotateZ(e){return Hn.makeRotationZ(e),this.applyMatrix4(Hn),this}translate(e,t,n){return Hn.makeTranslation(e,t,n),this.applyMatrix4(Hn),this}scale(e,t,n){return Hn.makeScale(e,t,n),this.applyMatrix4(Hn),this}lookAt(e){return Fd.lookAt(e),Fd.updateMatrix(),this.applyMatrix4(Fd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(xr).negate(),this.translate(xr.x,xr.y,xr.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Ne(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&De("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new kt);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Ve("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new E(-1/0,-1/0,-1/0),new E(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];In.setFromBufferAttribute(r),this.morphTargetsRelative?(Ht.addVectors(this.boundingBox.min,In.min),this.boundingBox.expandByPoint(Ht),Ht.addVectors(this.boundingBox.max,In.max),this.boundingBox.expandByPoint(Ht)):(this.boundingBox.expandByPoint(In.min),this.boundingBox.expandByPoint(In.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Ve('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ln);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Ve("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new E,1/0);return}if(e){let n=this.boundingSphere.center;if(In.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Uo.setFromBufferAttribute(a),this.morphTargetsRelative?(Ht.addVectors(In.min,Uo.min),In.expandByPoint(Ht),Ht.addVectors(In.max,Uo.max),In.expandByPoint(Ht)):(In.expandByPoint(Uo.min),In.expandByPoint(Uo.max))}In.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)Ht.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(Ht));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Ht.fromBufferAttribute(a,c),l&&(xr.fromBufferAttribute(e,c),Ht.add(xr)),s=Math.max(s,n.distanceToSquared(Ht))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Ve('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){Ve("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new ct(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let D=0;D<n.count;D++)a[D]=new E,l[D]=new E;let h=new E,u=new E,d=new E,f=new te,p=new te,x=new te,g=new E,m=new E;function y(D,P,k){c[D]=c[P]=c[k]=1,h.fromBufferAttribute(n,D),u.fromBufferAttribute(n,P),d.fromBufferAttribute(n,k),f.fromBufferAttribute(r,D),p.fromBufferAttribute(r,P),x.fromBufferAttribute(r,k),u.sub(h),d.sub(h),p.sub(f),x.sub(f);let O=1/(p.x*x.y-x.x*p.y);isFinite(O)&&(g.copy(u).multiplyScalar(x.y).addScaledVector(d,-p.y).multiplyScalar(O),m.copy(d).multiplyScalar(p.x).addScaledVector(u,-x.x).multiplyScalar(O),a[D].add(g),a[P].add(g),a[k].add(g),l[D].add(m),l[P].add(m),l[k].add(m))}let S=this.groups;S.length===0&&(S=[{start:0,count:e.count}]);for(let D=0,P=S.length;D<P;++D){let k=S[D],O=k.start,z=k.count;for(let I=O,H=O+z;I<H;I+=3)y(e.getX(I+0),e.getX(I+1),e.getX(I+2))}let b=new E,A=new E,R=new E,v=new E;function T(D){R.fromBufferAttribute(s,D),v.copy(R);let P=a[D];b.copy(P),b.sub(R.multiplyScalar(R.dot(P))).normalize(),A.crossVectors(v,P);let O=A.dot(l[D])<0?-1:1;o.setXYZW(D,b.x,b.y,b.z,O)}for(let D=0,P=n.count;D<P;++D)c[D]&&T(D);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new ct(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);let s=new E,r=new E,o=new E,a=new E,l=new E,c=new E,h=new E,u=new E;if(e)for(let d=0,f=e.count;d<f;d+=3){let p=e.getX(d+0),x=e.getX(d+1),g=e.getX(d+2);s.fromBufferAttribute(t,p),r.fromBufferAttribute(t,x),o.fromBufferAttribute(t,g),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,p),l.fromBufferAttribute(n,x),c.fromBufferAttribute(n,g),a.add(h),l.add(h),c.add(h),n.setXYZ(p,a.x,a.y,a.z),n.setXYZ(x,l.x,l.y,l.z),n.setXYZ(g,c.x,c.y,c.z)}else for(let d=0,f=t.count;d<f;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)Ht.fromBufferAttribute(e,t),Ht.normalize(),e.setXYZ(t,Ht.x,Ht.y,Ht.z)}toNonIndexed(){function e(a,l){let c=a.array,h=a.itemSize,u=a.normalized,d=new c.constructor(l.length*h),f=0,p=0;for(let x=0,g=l.length;x<g;x++){a.isInterleavedBufferAttribute?f=l[x]*a.data.stride+a.offset:f=l[x]*h;for(let m=0;m<h;m++)d[p++]=c[f++]}return new ct(d,h,u)}if(this.index===null)return De("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let d=c[h],f=e(d,n);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){let f=c[u];h.push(f.toJSON(e.data))}h.length>0&&(s[l]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(t))}let r=e.morphAttributes;for(let c in r){let h=[],u=r[c];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Fr=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=Df,this.updateRanges=[],this.version=0,this.uuid=Ui()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,n){e*=this.stride,n*=t.stride;for(let s=0,r=this.stride;s<r;s++)this.array[e+s]=t.array[n+s];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=tg(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let n=new this.array.constructor(e.arrayBuffers[t]),s=new this.constructor(n,this.stride);return s.setUsage(this.usage),s}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=tg(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function tg(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=Ui()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var fn=new E,Mn=class i{constructor(e,t,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=n,this.normalized=s,this._normalizationScale=e!==void 0?Uh(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,n=this.data.count;t<n;t++)fn.fromBufferAttribute(this,t),fn.applyMatrix4(e),this.setXYZ(t,fn.x,fn.y,fn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)fn.fromBufferAttribute(this,t),fn.applyNormalMatrix(e),this.setXYZ(t,fn.x,fn.y,fn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)fn.fromBufferAttribute(this,t),fn.transformDirection(e),this.setXYZ(t,fn.x,fn.y,fn.z);return this}getComponent(e,t){let n=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.data.array[e*this.data.stride+this.offset+t]=n,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,n){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.data.array[e+0]=t,this.data.array[e+1]=n,this}setXYZ(e,t,n,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this.data.array[e+3]=r,this}clone(e){if(e===void 0){Qo("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return new ct(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new i(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){Qo("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Uf(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Ff(e,this.data.array)}},Bd=new E,Ob=new E,Ub=new He,Ln=class{constructor(e=new E(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=Bd.subVectors(n,t).cross(Ob.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(Bd),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||Ub.getNormalMatrix(e),s=this.coplanarPoint(Bd).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},Fb=0,Sn=class extends ei{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Fb++}),this.uuid=Ui(),this.name="",this.type="Material",this.blending=Zr,this.side=cs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=df,this.blendDst=ff,this.blendEquation=Ws,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Re(0,0,0),this.blendAlpha=0,this.depthFunc=Ir,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=r0,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=fc,this.stencilZFail=fc,this.stencilZPass=fc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){De(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){De(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new Re().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new Ln().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new te().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new te().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}},Br=class extends Sn{constructor(e){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new Re(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.rotation=e.rotation,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},yr,Fo=new E,vr=new E,br=new E,_r=new te,Bo=new te,g0=new Le,Bl=new E,zo=new E,zl=new E,ng=new te,zd=new te,ig=new te,ra=class extends Nt{constructor(e=new Br){if(super(),this.isSprite=!0,this.type="Sprite",yr===void 0){yr=new We;let t=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),n=new Fr(t,5);yr.setIndex([0,1,2,0,2,3]),yr.setAttribute("position",new Mn(n,3,0,!1)),yr.setAttribute("uv",new Mn(n,2,3,!1))}this.geometry=yr,this.material=e,this.center=new te(.5,.5),this.count=1}intersectsFrustum(e){return e.intersectsSprite(this)}raycast(e,t){e.camera===null&&Ve('Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),vr.setFromMatrixScale(this.matrixWorld),g0.copy(e.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(e.camera.matrixWorldInverse,this.matrixWorld),br.setFromMatrixPosition(this.modelViewMatrix),e.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&vr.multiplyScalar(-br.z);let n=this.material.rotation,s,r;n!==0&&(r=Math.cos(n),s=Math.sin(n));let o=this.center;Vl(Bl.set(-.5,-.5,0),br,o,vr,s,r),Vl(zo.set(.5,-.5,0),br,o,vr,s,r),Vl(zl.set(.5,.5,0),br,o,vr,s,r),ng.set(0,0),zd.set(1,0),ig.set(1,1);let a=e.ray.intersectTriangle(Bl,zo,zl,!1,Fo);if(a===null&&(Vl(zo.set(-.5,.5,0),br,o,vr,s,r),zd.set(0,1),a=e.ray.intersectTriangle(Bl,zl,zo,!1,Fo),a===null))return;let l=e.ray.origin.distanceTo(Fo);l<e.near||l>e.far||t.push({distance:l,point:Fo.clone(),uv:ui.getInterpolation(Fo,Bl,zo,zl,ng,zd,ig,new te),face:null,object:this})}copy(e,t){return super.copy(e,t),e.center!==void 0&&this.center.copy(e.center),this.material=e.material,this}toJSON(e){let t=super.toJSON(e);return t.object.center=this.center.toArray(),t}};function Vl(i,e,t,n,s,r){_r.subVectors(i,t).addScalar(.5).multiply(n),s!==void 0?(Bo.x=r*_r.x-s*_r.y,Bo.y=s*_r.x+r*_r.y):Bo.copy(_r),i.copy(e),i.x+=Bo.x,i.y+=Bo.y,i.applyMatrix4(g0)}var Ri=new E,Vd=new E,Gl=new E,Hl=new E,fi=class{constructor(e=new E,t=new E(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Ri)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Ri.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Ri.copy(this.origin).addScaledVector(this.direction,t),Ri.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){Vd.copy(e).add(t).multiplyScalar(.5),Gl.copy(t).sub(e).normalize(),Hl.copy(this.origin).sub(Vd);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Gl),a=Hl.dot(this.direction),l=-Hl.dot(Gl),c=Hl.lengthSq(),h=Math.abs(1-o*o),u,d,f,p;if(h>0)if(u=o*l-a,d=o*a-l,p=r*h,u>=0)if(d>=-p)if(d<=p){let x=1/h;u*=x,d*=x,f=u*(u+o*d+2*a)+d*(o*u+d+2*l)+c}else d=r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d=-r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d<=-p?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c):d<=p?(u=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(Vd).addScaledVector(Gl,d),f}intersectSphere(e,t){if(e.radius<0)return null;Ri.subVectors(e.center,this.origin);let n=Ri.dot(this.direction),s=Ri.dot(Ri)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(n=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(n=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),h>=0?(r=(e.min.y-d.y)*h,o=(e.max.y-d.y)*h):(r=(e.max.y-d.y)*h,o=(e.min.y-d.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(e.min.z-d.z)*u,l=(e.max.z-d.z)*u):(a=(e.max.z-d.z)*u,l=(e.min.z-d.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,Ri)!==null}intersectTriangle(e,t,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=e.x-o.x,d=e.y-o.y,f=e.z-o.z,p=t.x-o.x,x=t.y-o.y,g=t.z-o.z,m=n.x-o.x,y=n.y-o.y,S=n.z-o.z,b=Math.abs(l),A=Math.abs(c),R=Math.abs(h),v,T,D,P,k,O,z,I,H,X,G,ne;if(b>=A&&b>=R?(D=l,O=u,H=p,ne=m,l>=0?(v=c,T=h,P=d,k=f,z=x,I=g,X=y,G=S):(v=h,T=c,P=f,k=d,z=g,I=x,X=S,G=y)):A>=R?(D=c,O=d,H=x,ne=y,c>=0?(v=h,T=l,P=f,k=u,z=g,I=p,X=S,G=m):(v=l,T=h,P=u,k=f,z=p,I=g,X=m,G=S)):(D=h,O=f,H=g,ne=S,h>=0?(v=l,T=c,P=u,k=d,z=p,I=x,X=m,G=y):(v=c,T=l,P=d,k=u,z=x,I=p,X=y,G=m)),D===0)return null;let $=v/D,J=T/D,ee=1/D,we=P-$*O,ke=k-J*O,Z=z-$*H,xe=I-J*H,Te=X-$*ne,Oe=G-J*ne,ve=Te*xe-Oe*Z,Ze=we*Oe-ke*Te,Ct=Z*ke-xe*we;if(s){if(ve<0||Ze<0||Ct<0)return null}else if((ve<0||Ze<0||Ct<0)&&(ve>0||Ze>0||Ct>0))return null;let Fe=ve+Ze+Ct;if(Fe===0)return null;let pt=ee*(ve*O+Ze*H+Ct*ne);return(Fe>0?pt<0:pt>0)?null:this.at(pt/Fe,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},cn=class extends Sn{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Re(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ti,this.combine=Oa,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},sg=new Le,Is=new fi,Wl=new ln,rg=new E,$l=new E,Xl=new E,ql=new E,Gd=new E,Yl=new E,og=new E,Zl=new E,st=class extends Nt{constructor(e=new We,t=new cn){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Yl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(Gd.fromBufferAttribute(u,e),o?Yl.addScaledVector(Gd,h):Yl.addScaledVector(Gd.sub(t),h))}t.add(Yl)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Wl.copy(n.boundingSphere),Wl.applyMatrix4(r),Is.copy(e.ray).recast(e.near),!(Wl.containsPoint(Is.origin)===!1&&(Is.intersectSphere(Wl,rg)===null||Is.origin.distanceToSquared(rg)>(e.far-e.near)**2))&&(sg.copy(r).invert(),Is.copy(e.ray).applyMatrix4(sg),!(n.boundingBox!==null&&Is.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,Is)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,x=d.length;p<x;p++){let g=d[p],m=o[g.materialIndex],y=Math.max(g.start,f.start),S=Math.min(a.count,Math.min(g.start+g.count,f.start+f.count));for(let b=y,A=S;b<A;b+=3){let R=a.getX(b),v=a.getX(b+1),T=a.getX(b+2);s=jl(this,m,e,n,c,h,u,R,v,T),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),x=Math.min(a.count,f.start+f.count);for(let g=p,m=x;g<m;g+=3){let y=a.getX(g),S=a.getX(g+1),b=a.getX(g+2);s=jl(this,o,e,n,c,h,u,y,S,b),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,x=d.length;p<x;p++){let g=d[p],m=o[g.materialIndex],y=Math.max(g.start,f.start),S=Math.min(l.count,Math.min(g.start+g.count,f.start+f.count));for(let b=y,A=S;b<A;b+=3){let R=b,v=b+1,T=b+2;s=jl(this,m,e,n,c,h,u,R,v,T),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),x=Math.min(l.count,f.start+f.count);for(let g=p,m=x;g<m;g+=3){let y=g,S=g+1,b=g+2;s=jl(this,o,e,n,c,h,u,y,S,b),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}}};function Bb(i,e,t,n,s,r,o,a){let l;if(e.side===xn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===cs,a),l===null)return null;Zl.copy(a),Zl.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Zl);return c<t.near||c>t.far?null:{distance:c,point:Zl.clone(),object:i}}function jl(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,$l),i.getVertexPosition(l,Xl),i.getVertexPosition(c,ql);let h=Bb(i,e,t,n,$l,Xl,ql,og);if(h){let u=new E;ui.getBarycoord(og,$l,Xl,ql,u),s&&(h.uv=ui.getInterpolatedAttribute(s,a,l,c,u,new te)),r&&(h.uv1=ui.getInterpolatedAttribute(r,a,l,c,u,new te)),o&&(h.normal=ui.getInterpolatedAttribute(o,a,l,c,u,new E),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new E,materialIndex:0};ui.getNormal($l,Xl,ql,d.normal),h.face=d,h.barycoord=u}return h}var oa=class extends gn{constructor(e=null,t=1,n=1,s,r,o,a,l,c=Wt,h=Wt,u,d){super(null,o,a,l,c,h,s,r,u,d),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var zr=class extends ct{constructor(e,t,n,s=1){super(e,t,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},wr=new Le,ag=new Le,Kl=[],lg=new kt,zb=new Le,Vo=new st,Go=new ln,aa=class extends st{constructor(e,t,n){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new zr(new Float32Array(n*16),16),this.instanceColor=null,this.morphTexture=null,this.count=n,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<n;s++)this.setMatrixAt(s,zb)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new kt),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,wr),lg.copy(e.boundingBox).applyMatrix4(wr),this.boundingBox.union(lg)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new ln),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,wr),Go.copy(e.boundingSphere).applyMatrix4(wr),this.boundingSphere.union(Go)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let n=t.morphTargetInfluences,s=this.morphTexture.source.data.data,r=n.length+1,o=e*r+1;for(let a=0;a<n.length;a++)n[a]=s[o+a]}raycast(e,t){let n=this.matrixWorld,s=this.count;if(Vo.geometry=this.geometry,Vo.material=this.material,Vo.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Go.copy(this.boundingSphere),Go.applyMatrix4(n),e.ray.intersectsSphere(Go)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,wr),ag.multiplyMatrices(n,wr),Vo.matrixWorld=ag,Vo.raycast(e,Kl);for(let o=0,a=Kl.length;o<a;o++){let l=Kl[o];l.instanceId=r,l.object=this,t.push(l)}Kl.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new zr(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let n=t.morphTargetInfluences,s=n.length+1;this.morphTexture===null&&(this.morphTexture=new oa(new Float32Array(s*this.count),s,this.count,ih,Xn));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<n.length;c++)o+=n[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*e;return r[l]=a,r.set(n,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Ls=new ln,Vb=new te(.5,.5),Jl=new E,es=class{constructor(e=new Ln,t=new Ln,n=new Ln,s=new Ln,r=new Ln,o=new Ln){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=Wn,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],d=r[6],f=r[7],p=r[8],x=r[9],g=r[10],m=r[11],y=r[12],S=r[13],b=r[14],A=r[15];if(s[0].setComponents(c-o,f-h,m-p,A-y).normalize(),s[1].setComponents(c+o,f+h,m+p,A+y).normalize(),s[2].setComponents(c+a,f+u,m+x,A+S).normalize(),s[3].setComponents(c-a,f-u,m-x,A-S).normalize(),n)s[4].setComponents(l,d,g,b).normalize(),s[5].setComponents(c-l,f-d,m-g,A-b).normalize();else if(s[4].setComponents(c-l,f-d,m-g,A-b).normalize(),t===Wn)s[5].setComponents(c+l,f+d,m+g,A+b).normalize();else if(t===Dr)s[5].setComponents(l,d,g,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Ls.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Ls.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Ls)}intersectsSprite(e){Ls.center.set(0,0,0);let t=Vb.distanceTo(e.center);return Ls.radius=.7071067811865476+t,Ls.applyMatrix4(e.matrixWorld),this.intersectsSphere(Ls)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(Jl.x=s.normal.x>0?e.max.x:e.min.x,Jl.y=s.normal.y>0?e.max.y:e.min.y,Jl.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Jl)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},cg=new Le,Ec=class i{constructor(){this.coordinateSystem=Wn,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];cg.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new es),n[s].setFromProjectionMatrix(cg,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new es),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var Ds=class extends Sn{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Re(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Ac=new E,Rc=new E,hg=new Le,Ho=new fi,Ql=new ln,Hd=new E,ug=new E,Cc=class extends Nt{constructor(e=new We,t=new Ds){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)Ac.fromBufferAttribute(t,s-1),Rc.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=Ac.distanceTo(Rc);e.setAttribute("lineDistance",new Ne(n,1))}else De("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Ql.copy(n.boundingSphere),Ql.applyMatrix4(s),Ql.radius+=r,e.ray.intersectsSphere(Ql)===!1)return;hg.copy(s).invert(),Ho.copy(e.ray).applyMatrix4(hg);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,d=n.attributes.position;if(h!==null){let f=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let x=f,g=p-1;x<g;x+=c){let m=h.getX(x),y=h.getX(x+1),S=ec(this,e,Ho,l,m,y,x);S&&t.push(S)}if(this.isLineLoop){let x=h.getX(p-1),g=h.getX(f),m=ec(this,e,Ho,l,x,g,p-1);m&&t.push(m)}}else{let f=Math.max(0,o.start),p=Math.min(d.count,o.start+o.count);for(let x=f,g=p-1;x<g;x+=c){let m=ec(this,e,Ho,l,x,x+1,x);m&&t.push(m)}if(this.isLineLoop){let x=ec(this,e,Ho,l,p-1,f,p-1);x&&t.push(x)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function ec(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(Ac.fromBufferAttribute(a,s),Rc.fromBufferAttribute(a,r),t.distanceSqToSegment(Ac,Rc,Hd,ug)>n)return;Hd.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Hd);if(!(c<e.near||c>e.far))return{distance:c,point:ug.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var dg=new E,fg=new E,Vr=class extends Cc{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)dg.fromBufferAttribute(t,s),fg.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+dg.distanceTo(fg);e.setAttribute("lineDistance",new Ne(n,1))}else De("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Gr=class extends Sn{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new Re(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},pg=new Le,ef=new fi,tc=new ln,nc=new E,la=class extends Nt{constructor(e=new We,t=new Gr){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Points.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),tc.copy(n.boundingSphere),tc.applyMatrix4(s),tc.radius+=r,e.ray.intersectsSphere(tc)===!1)return;pg.copy(s).invert(),ef.copy(e.ray).applyMatrix4(pg);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=n.index,u=n.attributes.position;if(c!==null){let d=Math.max(0,o.start),f=Math.min(c.count,o.start+o.count);for(let p=d,x=f;p<x;p++){let g=c.getX(p);nc.fromBufferAttribute(u,g),mg(nc,g,l,s,e,t,this)}}else{let d=Math.max(0,o.start),f=Math.min(u.count,o.start+o.count);for(let p=d,x=f;p<x;p++)nc.fromBufferAttribute(u,p),mg(nc,p,l,s,e,t,this)}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function mg(i,e,t,n,s,r,o){let a=ef.distanceSqToPoint(i);if(a<t){let l=new E;ef.closestPointToPoint(i,l),l.applyMatrix4(n);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:e,face:null,faceIndex:null,barycoord:null,object:o})}}var ca=class extends gn{constructor(e=[],t=$s,n,s,r,o,a,l,c,h){super(e,t,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}},Ns=class extends gn{constructor(e,t,n,s,r,o,a,l,c){super(e,t,n,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var Ii=class extends gn{constructor(e,t,n=ni,s,r,o,a=Wt,l=Wt,c,h=Pi,u=1){if(h!==Pi&&h!==ki)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:u};super(d,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Or(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},ha=class extends Ii{constructor(e,t=ni,n=$s,s,r,o=Wt,a=Wt,l,c=Pi){let h={width:e,height:e,depth:1},u=[h,h,h,h,h,h];super(e,e,t,n,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},ua=class extends gn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Nn=class i extends We{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],d=0,f=0;p("z","y","x",-1,-1,n,t,e,o,r,0),p("z","y","x",1,-1,n,t,-e,o,r,1),p("x","z","y",1,1,e,n,t,s,o,2),p("x","z","y",1,-1,e,n,-t,s,o,3),p("x","y","z",1,-1,e,t,n,s,r,4),p("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new Ne(c,3)),this.setAttribute("normal",new Ne(h,3)),this.setAttribute("uv",new Ne(u,2));function p(x,g,m,y,S,b,A,R,v,T,D){let P=b/v,k=A/T,O=b/2,z=A/2,I=R/2,H=v+1,X=T+1,G=0,ne=0,$=new E;for(let J=0;J<X;J++){let ee=J*k-z;for(let we=0;we<H;we++){let ke=we*P-O;$[x]=ke*y,$[g]=ee*S,$[m]=I,c.push($.x,$.y,$.z),$[x]=0,$[g]=0,$[m]=R>0?1:-1,h.push($.x,$.y,$.z),u.push(we/v),u.push(1-J/T),G+=1}}for(let J=0;J<T;J++)for(let ee=0;ee<v;ee++){let we=d+ee+H*J,ke=d+ee+H*(J+1),Z=d+(ee+1)+H*(J+1),xe=d+(ee+1)+H*J;l.push(we,ke,xe),l.push(ke,Z,xe),ne+=6}a.addGroup(f,ne,D),f+=ne,d+=G}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}},ks=class i extends We{constructor(e=1,t=1,n=4,s=8,r=1){super(),this.type="CapsuleGeometry",this.parameters={radius:e,height:t,capSegments:n,radialSegments:s,heightSegments:r},t=Math.max(0,t),n=Math.max(1,Math.floor(n)),s=Math.max(3,Math.floor(s)),r=Math.max(1,Math.floor(r));let o=[],a=[],l=[],c=[],h=t/2,u=Math.PI/2*e,d=t,f=2*u+d,p=n*2+r,x=s+1,g=new E,m=new E;for(let y=0;y<=p;y++){let S=0,b=0,A=0,R=0;if(y<=n){let D=y/n,P=D*Math.PI/2;b=-h-e*Math.cos(P),A=e*Math.sin(P),R=-e*Math.cos(P),S=D*u}else if(y<=n+r){let D=(y-n)/r;b=-h+D*t,A=e,R=0,S=u+D*d}else{let D=(y-n-r)/n,P=D*Math.PI/2;b=h+e*Math.sin(P),A=e*Math.cos(P),R=e*Math.sin(P),S=u+d+D*u}let v=Math.max(0,Math.min(1,S/f)),T=0;y===0?T=.5/s:y===p&&(T=-.5/s);for(let D=0;D<=s;D++){let P=D/s,k=P*Math.PI*2,O=Math.sin(k),z=Math.cos(k);m.x=-A*z,m.y=b,m.z=A*O,a.push(m.x,m.y,m.z),g.set(-A*z,R,A*O),g.normalize(),l.push(g.x,g.y,g.z),c.push(P+T,v)}if(y>0){let D=(y-1)*x;for(let P=0;P<s;P++){let k=D+P,O=D+P+1,z=y*x+P,I=y*x+P+1;o.push(k,O,z),o.push(O,I,z)}}}this.setIndex(o),this.setAttribute("position",new Ne(a,3)),this.setAttribute("normal",new Ne(l,3)),this.setAttribute("uv",new Ne(c,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.height,e.capSegments,e.radialSegments,e.heightSegments)}},ts=class i extends We{constructor(e=1,t=32,n=0,s=Math.PI*2){super(),this.type="CircleGeometry",this.parameters={radius:e,segments:t,thetaStart:n,thetaLength:s},t=Math.max(3,t);let r=[],o=[],a=[],l=[],c=new E,h=new te;o.push(0,0,0),a.push(0,0,1),l.push(.5,.5);for(let u=0,d=3;u<=t;u++,d+=3){let f=n+u/t*s;c.x=e*Math.cos(f),c.y=e*Math.sin(f),o.push(c.x,c.y,c.z),a.push(0,0,1),h.x=(o[d]/e+1)/2,h.y=(o[d+1]/e+1)/2,l.push(h.x,h.y)}for(let u=1;u<=t;u++)r.push(u,u+1,0);this.setIndex(r),this.setAttribute("position",new Ne(o,3)),this.setAttribute("normal",new Ne(a,3)),this.setAttribute("uv",new Ne(l,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.segments,e.thetaStart,e.thetaLength)}},ns=class i extends We{constructor(e=1,t=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],d=[],f=[],p=0,x=[],g=n/2,m=0;y(),o===!1&&(e>0&&S(!0),t>0&&S(!1)),this.setIndex(h),this.setAttribute("position",new Ne(u,3)),this.setAttribute("normal",new Ne(d,3)),this.setAttribute("uv",new Ne(f,2));function y(){let b=new E,A=new E,R=0,v=(t-e)/n;for(let T=0;T<=r;T++){let D=[],P=T/r,k=P*(t-e)+e;for(let O=0;O<=s;O++){let z=O/s,I=z*l+a,H=Math.sin(I),X=Math.cos(I);A.x=k*H,A.y=-P*n+g,A.z=k*X,u.push(A.x,A.y,A.z),b.set(H,v,X).normalize(),d.push(b.x,b.y,b.z),f.push(z,1-P),D.push(p++)}x.push(D)}for(let T=0;T<s;T++)for(let D=0;D<r;D++){let P=x[D][T],k=x[D+1][T],O=x[D+1][T+1],z=x[D][T+1];(e>0||D!==0)&&(h.push(P,k,z),R+=3),(t>0||D!==r-1)&&(h.push(k,O,z),R+=3)}c.addGroup(m,R,0),m+=R}function S(b){let A=p,R=new te,v=new E,T=0,D=b===!0?e:t,P=b===!0?1:-1;for(let O=1;O<=s;O++)u.push(0,g*P,0),d.push(0,P,0),f.push(.5,.5),p++;let k=p;for(let O=0;O<=s;O++){let I=O/s*l+a,H=Math.cos(I),X=Math.sin(I);v.x=D*X,v.y=g*P,v.z=D*H,u.push(v.x,v.y,v.z),d.push(0,P,0),R.x=H*.5+.5,R.y=X*.5*P+.5,f.push(R.x,R.y),p++}for(let O=0;O<s;O++){let z=A+O,I=k+O;b===!0?h.push(I,I+1,z):h.push(I+1,I,z),T+=3}c.addGroup(m,T,b===!0?1:2),m+=T}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},Os=class i extends ns{constructor(e=1,t=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new i(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var ic=new E,sc=new E,Wd=new E,rc=new ui,da=class extends We{constructor(e=null,t=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:e,thresholdAngle:t},e!==null){let s=Math.pow(10,4),r=Math.cos(Rr*t),o=e.getIndex(),a=e.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],h=["a","b","c"],u=new Array(3),d=new Map,f=[];for(let p=0;p<l;p+=3){o?(c[0]=o.getX(p),c[1]=o.getX(p+1),c[2]=o.getX(p+2)):(c[0]=p,c[1]=p+1,c[2]=p+2);let{a:x,b:g,c:m}=rc;if(x.fromBufferAttribute(a,c[0]),g.fromBufferAttribute(a,c[1]),m.fromBufferAttribute(a,c[2]),rc.getNormal(Wd),u[0]=`${Math.round(x.x*s)},${Math.round(x.y*s)},${Math.round(x.z*s)}`,u[1]=`${Math.round(g.x*s)},${Math.round(g.y*s)},${Math.round(g.z*s)}`,u[2]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,!(u[0]===u[1]||u[1]===u[2]||u[2]===u[0]))for(let y=0;y<3;y++){let S=(y+1)%3,b=u[y],A=u[S],R=rc[h[y]],v=rc[h[S]],T=`${b}_${A}`,D=`${A}_${b}`,P=d.get(D);P?(Wd.dot(P.normal)<=r&&(f.push(R.x,R.y,R.z),f.push(v.x,v.y,v.z)),d.set(D,null)):d.has(T)||d.set(T,{index0:c[y],index1:c[S],normal:Wd.clone()})}}for(let p of d.values())if(p){let{index0:x,index1:g}=p;ic.fromBufferAttribute(a,x),sc.fromBufferAttribute(a,g),f.push(ic.x,ic.y,ic.z),f.push(sc.x,sc.y,sc.z)}this.setAttribute("position",new Ne(f,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}},kn=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){De("Curve: .getPoint() not implemented.")}getPointAt(e,t){let n=this.getUtoTmapping(e);return this.getPoint(n,t)}getPoints(e=5){let t=[];for(let n=0;n<=e;n++)t.push(this.getPoint(n/e));return t}getSpacedPoints(e=5){let t=[];for(let n=0;n<=e;n++)t.push(this.getPointAt(n/e));return t}getLength(){let e=this.getLengths();return e[e.length-1]}getLengths(e=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===e+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let t=[],n,s=this.getPoint(0),r=0;t.push(0);for(let o=1;o<=e;o++)n=this.getPoint(o/e),r+=n.distanceTo(s),t.push(r),s=n;return this.cacheArcLengths=t,t}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(e,t=null){let n=this.getLengths(),s=0,r=n.length,o;t?o=t:o=e*n[r-1];let a=0,l=r-1,c;for(;a<=l;)if(s=Math.floor(a+(l-a)/2),c=n[s]-o,c<0)a=s+1;else if(c>0)l=s-1;else{l=s;break}if(s=l,n[s]===o)return s/(r-1);let h=n[s],d=n[s+1]-h,f=(o-h)/d;return(s+f)/(r-1)}getTangent(e,t){let s=e-1e-4,r=e+1e-4;s<0&&(s=0),r>1&&(r=1);let o=this.getPoint(s),a=this.getPoint(r),l=t||(o.isVector2?new te:new E);return l.copy(a).sub(o).normalize(),l}getTangentAt(e,t){let n=this.getUtoTmapping(e);return this.getTangent(n,t)}computeFrenetFrames(e,t=!1){let n=new E,s=[],r=[],o=[],a=new E,l=new Le;for(let f=0;f<=e;f++){let p=f/e;s[f]=this.getTangentAt(p,new E)}r[0]=new E,o[0]=new E;let c=Number.MAX_VALUE,h=Math.abs(s[0].x),u=Math.abs(s[0].y),d=Math.abs(s[0].z);h<=c&&(c=h,n.set(1,0,0)),u<=c&&(c=u,n.set(0,1,0)),d<=c&&n.set(0,0,1),a.crossVectors(s[0],n).normalize(),r[0].crossVectors(s[0],a),o[0].crossVectors(s[0],r[0]);for(let f=1;f<=e;f++){if(r[f]=r[f-1].clone(),o[f]=o[f-1].clone(),a.crossVectors(s[f-1],s[f]),a.length()>Number.EPSILON){a.normalize();let p=Math.acos(Ge(s[f-1].dot(s[f]),-1,1));r[f].applyMatrix4(l.makeRotationAxis(a,p))}o[f].crossVectors(s[f],r[f])}if(t===!0){let f=Math.acos(Ge(r[0].dot(r[e]),-1,1));f/=e,s[0].dot(a.crossVectors(r[0],r[e]))>0&&(f=-f);for(let p=1;p<=e;p++)r[p].applyMatrix4(l.makeRotationAxis(s[p],f*p)),o[p].crossVectors(s[p],r[p])}return{tangents:s,normals:r,binormals:o}}clone(){return new this.constructor().copy(this)}copy(e){return this.arcLengthDivisions=e.arcLengthDivisions,this.cacheArcLengths=null,this}toJSON(){let e={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return e.arcLengthDivisions=this.arcLengthDivisions,e.type=this.type,e}fromJSON(e){return this.arcLengthDivisions=e.arcLengthDivisions,this.cacheArcLengths=null,this}},Hr=class extends kn{constructor(e=0,t=0,n=1,s=1,r=0,o=Math.PI*2,a=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=e,this.aY=t,this.xRadius=n,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=o,this.aClockwise=a,this.aRotation=l}getPoint(e,t=new te){let n=t,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,o=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(o?r=0:r=s),this.aClockwise===!0&&!o&&(r===s?r=-s:r=r-s);let a=this.aStartAngle+e*r,l=this.aX+this.xRadius*Math.cos(a),c=this.aY+this.yRadius*Math.sin(a);if(this.aRotation!==0){let h=Math.cos(this.aRotation),u=Math.sin(this.aRotation),d=l-this.aX,f=c-this.aY;l=d*h-f*u+this.aX,c=d*u+f*h+this.aY}return n.set(l,c)}copy(e){return super.copy(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}toJSON(){let e=super.toJSON();return e.aX=this.aX,e.aY=this.aY,e.xRadius=this.xRadius,e.yRadius=this.yRadius,e.aStartAngle=this.aStartAngle,e.aEndAngle=this.aEndAngle,e.aClockwise=this.aClockwise,e.aRotation=this.aRotation,e}fromJSON(e){return super.fromJSON(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}},Pc=class extends Hr{constructor(e,t,n,s,r,o){super(e,t,n,n,s,r,o),this.isArcCurve=!0,this.type="ArcCurve"}};function Bf(){let i=0,e=0,t=0,n=0;function s(r,o,a,l){i=r,e=a,t=-3*r+3*o-2*a-l,n=2*r-2*o+a+l}return{initCatmullRom:function(r,o,a,l,c){s(o,a,c*(a-r),c*(l-o))},initNonuniformCatmullRom:function(r,o,a,l,c,h,u){let d=(o-r)/c-(a-r)/(c+h)+(a-o)/h,f=(a-o)/h-(l-o)/(h+u)+(l-a)/u;d*=h,f*=h,s(o,a,d,f)},calc:function(r){let o=r*r,a=o*r;return i+e*r+t*o+n*a}}}var gg=new E,xg=new E,$d=new Bf,Xd=new Bf,qd=new Bf,Ic=class extends kn{constructor(e=[],t=!1,n="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=e,this.closed=t,this.curveType=n,this.tension=s}getPoint(e,t=new E){let n=t,s=this.points,r=s.length,o=(r-(this.closed?0:1))*e,a=Math.floor(o),l=o-a;this.closed?a+=a>0?0:(Math.floor(Math.abs(a)/r)+1)*r:l===0&&a===r-1&&(a=r-2,l=1);let c,h;this.closed||a>0?c=s[(a-1)%r]:(xg.subVectors(s[0],s[1]).add(s[0]),c=xg);let u=s[a%r],d=s[(a+1)%r];if(this.closed||a+2<r?h=s[(a+2)%r]:(gg.subVectors(s[r-1],s[r-2]).add(s[r-1]),h=gg),this.curveType==="centripetal"||this.curveType==="chordal"){let f=this.curveType==="chordal"?.5:.25,p=Math.pow(c.distanceToSquared(u),f),x=Math.pow(u.distanceToSquared(d),f),g=Math.pow(d.distanceToSquared(h),f);x<1e-4&&(x=1),p<1e-4&&(p=x),g<1e-4&&(g=x),$d.initNonuniformCatmullRom(c.x,u.x,d.x,h.x,p,x,g),Xd.initNonuniformCatmullRom(c.y,u.y,d.y,h.y,p,x,g),qd.initNonuniformCatmullRom(c.z,u.z,d.z,h.z,p,x,g)}else this.curveType==="catmullrom"&&($d.initCatmullRom(c.x,u.x,d.x,h.x,this.tension),Xd.initCatmullRom(c.y,u.y,d.y,h.y,this.tension),qd.initCatmullRom(c.z,u.z,d.z,h.z,this.tension));return n.set($d.calc(l),Xd.calc(l),qd.calc(l)),n}copy(e){super.copy(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(s.clone())}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,n=this.points.length;t<n;t++){let s=this.points[t];e.points.push(s.toArray())}return e.closed=this.closed,e.curveType=this.curveType,e.tension=this.tension,e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(new E().fromArray(s))}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}};function yg(i,e,t,n,s){let r=(n-e)*.5,o=(s-t)*.5,a=i*i,l=i*a;return(2*t-2*n+r+o)*l+(-3*t+3*n-2*r-o)*a+r*i+t}function Gb(i,e){let t=1-i;return t*t*e}function Hb(i,e){return 2*(1-i)*i*e}function Wb(i,e){return i*i*e}function qo(i,e,t,n){return Gb(i,e)+Hb(i,t)+Wb(i,n)}function $b(i,e){let t=1-i;return t*t*t*e}function Xb(i,e){let t=1-i;return 3*t*t*i*e}function qb(i,e){return 3*(1-i)*i*i*e}function Yb(i,e){return i*i*i*e}function Yo(i,e,t,n,s){return $b(i,e)+Xb(i,t)+qb(i,n)+Yb(i,s)}var fa=class extends kn{constructor(e=new te,t=new te,n=new te,s=new te){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=e,this.v1=t,this.v2=n,this.v3=s}getPoint(e,t=new te){let n=t,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(Yo(e,s.x,r.x,o.x,a.x),Yo(e,s.y,r.y,o.y,a.y)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},Lc=class extends kn{constructor(e=new E,t=new E,n=new E,s=new E){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=e,this.v1=t,this.v2=n,this.v3=s}getPoint(e,t=new E){let n=t,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(Yo(e,s.x,r.x,o.x,a.x),Yo(e,s.y,r.y,o.y,a.y),Yo(e,s.z,r.z,o.z,a.z)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},pa=class extends kn{constructor(e=new te,t=new te){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=e,this.v2=t}getPoint(e,t=new te){let n=t;return e===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(e).add(this.v1)),n}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new te){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},Dc=class extends kn{constructor(e=new E,t=new E){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=e,this.v2=t}getPoint(e,t=new E){let n=t;return e===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(e).add(this.v1)),n}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new E){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},ma=class extends kn{constructor(e=new te,t=new te,n=new te){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=e,this.v1=t,this.v2=n}getPoint(e,t=new te){let n=t,s=this.v0,r=this.v1,o=this.v2;return n.set(qo(e,s.x,r.x,o.x),qo(e,s.y,r.y,o.y)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},Nc=class extends kn{constructor(e=new E,t=new E,n=new E){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=e,this.v1=t,this.v2=n}getPoint(e,t=new E){let n=t,s=this.v0,r=this.v1,o=this.v2;return n.set(qo(e,s.x,r.x,o.x),qo(e,s.y,r.y,o.y),qo(e,s.z,r.z,o.z)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},ga=class extends kn{constructor(e=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=e}getPoint(e,t=new te){let n=t,s=this.points,r=(s.length-1)*e,o=Math.floor(r),a=r-o,l=s[o===0?o:o-1],c=s[o],h=s[o>s.length-2?s.length-1:o+1],u=s[o>s.length-3?s.length-1:o+2];return n.set(yg(a,l.x,c.x,h.x,u.x),yg(a,l.y,c.y,h.y,u.y)),n}copy(e){super.copy(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(s.clone())}return this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,n=this.points.length;t<n;t++){let s=this.points[t];e.points.push(s.toArray())}return e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(new te().fromArray(s))}return this}},vg=Object.freeze({__proto__:null,ArcCurve:Pc,CatmullRomCurve3:Ic,CubicBezierCurve:fa,CubicBezierCurve3:Lc,EllipseCurve:Hr,LineCurve:pa,LineCurve3:Dc,QuadraticBezierCurve:ma,QuadraticBezierCurve3:Nc,SplineCurve:ga}),kc=class extends kn{constructor(){super(),this.type="CurvePath",this.curves=[],this.autoClose=!1,this.cacheLengths=null}add(e){this.curves.push(e)}closePath(){let e=this.curves[0].getPoint(0),t=this.curves[this.curves.length-1].getPoint(1);if(!e.equals(t)){let n=e.isVector2===!0?"LineCurve":"LineCurve3";this.curves.push(new vg[n](t,e))}return this}getPoint(e,t){let n=e*this.getLength(),s=this.getCurveLengths(),r=0;for(;r<s.length;){if(s[r]>=n){let o=s[r]-n,a=this.curves[r],l=a.getLength(),c=l===0?0:1-o/l;return a.getPointAt(c,t)}r++}return null}getLength(){let e=this.getCurveLengths();return e[e.length-1]}updateArcLengths(){this.needsUpdate=!0,this.cacheLengths=null,this.getCurveLengths()}getCurveLengths(){if(this.cacheLengths&&this.cacheLengths.length===this.curves.length)return this.cacheLengths;let e=[],t=0;for(let n=0,s=this.curves.length;n<s;n++)t+=this.curves[n].getLength(),e.push(t);return this.cacheLengths=e,e}getSpacedPoints(e=40){let t=[];for(let n=0;n<=e;n++)t.push(this.getPoint(n/e));return this.autoClose&&t.push(t[0]),t}getPoints(e=12){let t=[],n;for(let s=0,r=this.curves;s<r.length;s++){let o=r[s],a=o.isEllipseCurve?e*2:o.isLineCurve||o.isLineCurve3?1:o.isSplineCurve?e*o.points.length:e,l=o.getPoints(a);for(let c=0;c<l.length;c++){let h=l[c];n&&n.equals(h)||(t.push(h),n=h)}}return this.autoClose&&t.length>1&&!t[t.length-1].equals(t[0])&&t.push(t[0]),t}copy(e){super.copy(e),this.curves=[];for(let t=0,n=e.curves.length;t<n;t++){let s=e.curves[t];this.curves.push(s.clone())}return this.autoClose=e.autoClose,this.cacheLengths=null,this}toJSON(){let e=super.toJSON();e.autoClose=this.autoClose,e.curves=[];for(let t=0,n=this.curves.length;t<n;t++){let s=this.curves[t];e.curves.push(s.toJSON())}return e}fromJSON(e){super.fromJSON(e),this.autoClose=e.autoClose,this.curves=[];for(let t=0,n=e.curves.length;t<n;t++){let s=e.curves[t];this.curves.push(new vg[s.type]().fromJSON(s))}return this.cacheLengths=null,this}},xa=class extends kc{constructor(e){super(),this.type="Path",this.currentPoint=new te,e&&this.setFromPoints(e)}setFromPoints(e){this.moveTo(e[0].x,e[0].y);for(let t=1,n=e.length;t<n;t++)this.lineTo(e[t].x,e[t].y);return this}moveTo(e,t){return this.currentPoint.set(e,t),this}lineTo(e,t){let n=new pa(this.currentPoint.clone(),new te(e,t));return this.curves.push(n),this.currentPoint.set(e,t),this}quadraticCurveTo(e,t,n,s){let r=new ma(this.currentPoint.clone(),new te(e,t),new te(n,s));return this.curves.push(r),this.currentPoint.set(n,s),this}bezierCurveTo(e,t,n,s,r,o){let a=new fa(this.currentPoint.clone(),new te(e,t),new te(n,s),new te(r,o));return this.curves.push(a),this.currentPoint.set(r,o),this}splineThru(e){let t=[this.currentPoint.clone()].concat(e),n=new ga(t);return this.curves.push(n),this.currentPoint.copy(e[e.length-1]),this}arc(e,t,n,s,r,o){let a=this.currentPoint.x,l=this.currentPoint.y;return this.absarc(e+a,t+l,n,s,r,o),this}absarc(e,t,n,s,r,o){return this.absellipse(e,t,n,n,s,r,o),this}ellipse(e,t,n,s,r,o,a,l){let c=this.currentPoint.x,h=this.currentPoint.y;return this.absellipse(e+c,t+h,n,s,r,o,a,l),this}absellipse(e,t,n,s,r,o,a,l){let c=new Hr(e,t,n,s,r,o,a,l);if(this.curves.length>0){let u=c.getPoint(0);u.equals(this.currentPoint)||this.lineTo(u.x,u.y)}this.curves.push(c);let h=c.getPoint(1);return this.currentPoint.copy(h),this}copy(e){return super.copy(e),this.currentPoint.copy(e.currentPoint),this}toJSON(){let e=super.toJSON();return e.currentPoint=this.currentPoint.toArray(),e}fromJSON(e){return super.fromJSON(e),this.currentPoint.fromArray(e.currentPoint),this}},Li=class extends xa{constructor(e){super(e),this.uuid=Ui(),this.type="Shape",this.holes=[]}getPointsHoles(e){let t=[];for(let n=0,s=this.holes.length;n<s;n++)t[n]=this.holes[n].getPoints(e);return t}extractPoints(e){return{shape:this.getPoints(e),holes:this.getPointsHoles(e)}}copy(e){super.copy(e),this.holes=[];for(let t=0,n=e.holes.length;t<n;t++){let s=e.holes[t];this.holes.push(s.clone())}return this}toJSON(){let e=super.toJSON();e.uuid=this.uuid,e.holes=[];for(let t=0,n=this.holes.length;t<n;t++){let s=this.holes[t];e.holes.push(s.toJSON())}return e}fromJSON(e){super.fromJSON(e),this.uuid=e.uuid,this.holes=[];for(let t=0,n=e.holes.length;t<n;t++){let s=e.holes[t];this.holes.push(new xa().fromJSON(s))}return this}};function Zb(i,e,t=2){let n=e&&e.length,s=n?e[0]*t:i.length,r=x0(i,0,s,t,!0),o=[];if(!r||r.next===r.prev)return o;let a,l,c;if(n&&(r=e_(i,e,r,t)),i.length>80*t){a=i[0],l=i[1];let h=a,u=l;for(let d=t;d<s;d+=t){let f=i[d],p=i[d+1];f<a&&(a=f),p<l&&(l=p),f>h&&(h=f),p>u&&(u=p)}c=Math.max(h-a,u-l),c=c!==0?32767/c:0}return ya(r,o,t,a,l,c,0),o}function x0(i,e,t,n,s){let r;if(s===u_(i,e,t,n)>0)for(let o=e;o<t;o+=n)r=bg(o/n|0,i[o],i[o+1],r);else for(let o=t-n;o>=e;o-=n)r=bg(o/n|0,i[o],i[o+1],r);return r&&Wr(r,r.next)&&(ba(r),r=r.next),r}function Us(i,e){if(!i)return i;e||(e=i);let t=i,n;do if(n=!1,!t.steiner&&(Wr(t,t.next)||Tt(t.prev,t,t.next)===0)){if(ba(t),t=e=t.prev,t===t.next)break;n=!0}else t=t.next;while(n||t!==e);return e}function ya(i,e,t,n,s,r,o){if(!i)return;!o&&r&&r_(i,n,s,r);let a=i;for(;i.prev!==i.next;){let l=i.prev,c=i.next;if(r?Kb(i,n,s,r):jb(i)){e.push(l.i,i.i,c.i),ba(i),i=c.next,a=c.next;continue}if(i=c,i===a){o?o===1?(i=Jb(Us(i),e),ya(i,e,t,n,s,r,2)):o===2&&Qb(i,e,t,n,s,r):ya(Us(i),e,t,n,s,r,1);break}}}function jb(i){let e=i.prev,t=i,n=i.next;if(Tt(e,t,n)>=0)return!1;let s=e.x,r=t.x,o=n.x,a=e.y,l=t.y,c=n.y,h=Math.min(s,r,o),u=Math.min(a,l,c),d=Math.max(s,r,o),f=Math.max(a,l,c),p=n.next;for(;p!==e;){if(p.x>=h&&p.x<=d&&p.y>=u&&p.y<=f&&Wo(s,a,r,l,o,c,p.x,p.y)&&Tt(p.prev,p,p.next)>=0)return!1;p=p.next}return!0}function Kb(i,e,t,n){let s=i.prev,r=i,o=i.next;if(Tt(s,r,o)>=0)return!1;let a=s.x,l=r.x,c=o.x,h=s.y,u=r.y,d=o.y,f=Math.min(a,l,c),p=Math.min(h,u,d),x=Math.max(a,l,c),g=Math.max(h,u,d),m=tf(f,p,e,t,n),y=tf(x,g,e,t,n),S=i.prevZ,b=i.nextZ;for(;S&&S.z>=m&&b&&b.z<=y;){if(S.x>=f&&S.x<=x&&S.y>=p&&S.y<=g&&S!==s&&S!==o&&Wo(a,h,l,u,c,d,S.x,S.y)&&Tt(S.prev,S,S.next)>=0||(S=S.prevZ,b.x>=f&&b.x<=x&&b.y>=p&&b.y<=g&&b!==s&&b!==o&&Wo(a,h,l,u,c,d,b.x,b.y)&&Tt(b.prev,b,b.next)>=0))return!1;b=b.nextZ}for(;S&&S.z>=m;){if(S.x>=f&&S.x<=x&&S.y>=p&&S.y<=g&&S!==s&&S!==o&&Wo(a,h,l,u,c,d,S.x,S.y)&&Tt(S.prev,S,S.next)>=0)return!1;S=S.prevZ}for(;b&&b.z<=y;){if(b.x>=f&&b.x<=x&&b.y>=p&&b.y<=g&&b!==s&&b!==o&&Wo(a,h,l,u,c,d,b.x,b.y)&&Tt(b.prev,b,b.next)>=0)return!1;b=b.nextZ}return!0}function Jb(i,e){let t=i;do{let n=t.prev,s=t.next.next;!Wr(n,s)&&v0(n,t,t.next,s)&&va(n,s)&&va(s,n)&&(e.push(n.i,t.i,s.i),ba(t),ba(t.next),t=i=s),t=t.next}while(t!==i);return Us(t)}function Qb(i,e,t,n,s,r){let o=i;do{let a=o.next.next;for(;a!==o.prev;){if(o.i!==a.i&&l_(o,a)){let l=b0(o,a);o=Us(o,o.next),l=Us(l,l.next),ya(o,e,t,n,s,r,0),ya(l,e,t,n,s,r,0);return}a=a.next}o=o.next}while(o!==i)}function e_(i,e,t,n){let s=[];for(let r=0,o=e.length;r<o;r++){let a=e[r]*n,l=r<o-1?e[r+1]*n:i.length,c=x0(i,a,l,n,!1);c===c.next&&(c.steiner=!0),s.push(a_(c))}s.sort(t_);for(let r=0;r<s.length;r++)t=n_(s[r],t);return t}function t_(i,e){let t=i.x-e.x;if(t===0&&(t=i.y-e.y,t===0)){let n=(i.next.y-i.y)/(i.next.x-i.x),s=(e.next.y-e.y)/(e.next.x-e.x);t=n-s}return t}function n_(i,e){let t=i_(i,e);if(!t)return e;let n=b0(t,i);return Us(n,n.next),Us(t,t.next)}function i_(i,e){let t=e,n=i.x,s=i.y,r=-1/0,o;if(Wr(i,t))return t;do{if(Wr(i,t.next))return t.next;if(s<=t.y&&s>=t.next.y&&t.next.y!==t.y){let u=t.x+(s-t.y)*(t.next.x-t.x)/(t.next.y-t.y);if(u<=n&&u>r&&(r=u,o=t.x<t.next.x?t:t.next,u===n))return o}t=t.next}while(t!==e);if(!o)return null;let a=o,l=o.x,c=o.y,h=1/0;t=o;do{if(n>=t.x&&t.x>=l&&n!==t.x&&y0(s<c?n:r,s,l,c,s<c?r:n,s,t.x,t.y)){let u=Math.abs(s-t.y)/(n-t.x);va(t,i)&&(u<h||u===h&&(t.x>o.x||t.x===o.x&&s_(o,t)))&&(o=t,h=u)}t=t.next}while(t!==a);return o}function s_(i,e){return Tt(i.prev,i,e.prev)<0&&Tt(e.next,i,i.next)<0}function r_(i,e,t,n){let s=i;do s.z===0&&(s.z=tf(s.x,s.y,e,t,n)),s.prevZ=s.prev,s.nextZ=s.next,s=s.next;while(s!==i);s.prevZ.nextZ=null,s.prevZ=null,o_(s)}function o_(i){let e,t=1;do{let n=i,s;i=null;let r=null;for(e=0;n;){e++;let o=n,a=0;for(let c=0;c<t&&(a++,o=o.nextZ,!!o);c++);let l=t;for(;a>0||l>0&&o;)a!==0&&(l===0||!o||n.z<=o.z)?(s=n,n=n.nextZ,a--):(s=o,o=o.nextZ,l--),r?r.nextZ=s:i=s,s.prevZ=r,r=s;n=o}r.nextZ=null,t*=2}while(e>1);return i}function tf(i,e,t,n,s){return i=(i-t)*s|0,e=(e-n)*s|0,i=(i|i<<8)&16711935,i=(i|i<<4)&252645135,i=(i|i<<2)&858993459,i=(i|i<<1)&1431655765,e=(e|e<<8)&16711935,e=(e|e<<4)&252645135,e=(e|e<<2)&858993459,e=(e|e<<1)&1431655765,i|e<<1}function a_(i){let e=i,t=i;do(e.x<t.x||e.x===t.x&&e.y<t.y)&&(t=e),e=e.next;while(e!==i);return t}function y0(i,e,t,n,s,r,o,a){return(s-o)*(e-a)>=(i-o)*(r-a)&&(i-o)*(n-a)>=(t-o)*(e-a)&&(t-o)*(r-a)>=(s-o)*(n-a)}function Wo(i,e,t,n,s,r,o,a){return!(i===o&&e===a)&&y0(i,e,t,n,s,r,o,a)}function l_(i,e){return i.next.i!==e.i&&i.prev.i!==e.i&&!c_(i,e)&&(va(i,e)&&va(e,i)&&h_(i,e)&&(Tt(i.prev,i,e.prev)||Tt(i,e.prev,e))||Wr(i,e)&&Tt(i.prev,i,i.next)>0&&Tt(e.prev,e,e.next)>0)}function Tt(i,e,t){return(e.y-i.y)*(t.x-e.x)-(e.x-i.x)*(t.y-e.y)}function Wr(i,e){return i.x===e.x&&i.y===e.y}function v0(i,e,t,n){let s=ac(Tt(i,e,t)),r=ac(Tt(i,e,n)),o=ac(Tt(t,n,i)),a=ac(Tt(t,n,e));return!!(s!==r&&o!==a||s===0&&oc(i,t,e)||r===0&&oc(i,n,e)||o===0&&oc(t,i,n)||a===0&&oc(t,e,n))}function oc(i,e,t){return e.x<=Math.max(i.x,t.x)&&e.x>=Math.min(i.x,t.x)&&e.y<=Math.max(i.y,t.y)&&e.y>=Math.min(i.y,t.y)}function ac(i){return i>0?1:i<0?-1:0}function c_(i,e){let t=i;do{if(t.i!==i.i&&t.next.i!==i.i&&t.i!==e.i&&t.next.i!==e.i&&v0(t,t.next,i,e))return!0;t=t.next}while(t!==i);return!1}function va(i,e){return Tt(i.prev,i,i.next)<0?Tt(i,e,i.next)>=0&&Tt(i,i.prev,e)>=0:Tt(i,e,i.prev)<0||Tt(i,i.next,e)<0}function h_(i,e){let t=i,n=!1,s=(i.x+e.x)/2,r=(i.y+e.y)/2;do t.y>r!=t.next.y>r&&t.next.y!==t.y&&s<(t.next.x-t.x)*(r-t.y)/(t.next.y-t.y)+t.x&&(n=!n),t=t.next;while(t!==i);return n}function b0(i,e){let t=nf(i.i,i.x,i.y),n=nf(e.i,e.x,e.y),s=i.next,r=e.prev;return i.next=e,e.prev=i,t.next=s,s.prev=t,n.next=t,t.prev=n,r.next=n,n.prev=r,n}function bg(i,e,t,n){let s=nf(i,e,t);return n?(s.next=n.next,s.prev=n,n.next.prev=s,n.next=s):(s.prev=s,s.next=s),s}function ba(i){i.next.prev=i.prev,i.prev.next=i.next,i.prevZ&&(i.prevZ.nextZ=i.nextZ),i.nextZ&&(i.nextZ.prevZ=i.prevZ)}function nf(i,e,t){return{i,x:e,y:t,prev:null,next:null,z:0,prevZ:null,nextZ:null,steiner:!1}}function u_(i,e,t,n){let s=0;for(let r=e,o=t-n;r<t;r+=n)s+=(i[o]-i[r])*(i[r+1]+i[o+1]),o=r;return s}var sf=class{static triangulate(e,t,n=2){return Zb(e,t,n)}},Pr=class i{static area(e){let t=e.length,n=0;for(let s=t-1,r=0;r<t;s=r++)n+=e[s].x*e[r].y-e[r].x*e[s].y;return n*.5}static isClockWise(e){return i.area(e)<0}static triangulateShape(e,t){let n=[],s=[],r=[];_g(e),wg(n,e);let o=e.length;t.forEach(_g);for(let l=0;l<t.length;l++)s.push(o),o+=t[l].length,wg(n,t[l]);let a=sf.triangulate(n,s);for(let l=0;l<a.length;l+=3)r.push(a.slice(l,l+3));return r}};function _g(i){let e=i.length;e>2&&i[e-1].equals(i[0])&&i.pop()}function wg(i,e){for(let t=0;t<e.length;t++)i.push(e[t].x),i.push(e[t].y)}var _a=class i extends We{constructor(e=[new te(0,-.5),new te(.5,0),new te(0,.5)],t=12,n=0,s=Math.PI*2){super(),this.type="LatheGeometry",this.parameters={points:e,segments:t,phiStart:n,phiLength:s},t=Math.floor(t),s=Ge(s,0,Math.PI*2);let r=[],o=[],a=[],l=[],c=[],h=1/t,u=new E,d=new te,f=new E,p=new E,x=new E,g=0,m=0;for(let y=0;y<=e.length-1;y++)switch(y){case 0:g=e[y+1].x-e[y].x,m=e[y+1].y-e[y].y,f.x=m*1,f.y=-g,f.z=m*0,x.copy(f),f.normalize(),l.push(f.x,f.y,f.z);break;case e.length-1:x.normalize(),l.push(x.x,x.y,x.z);break;default:g=e[y+1].x-e[y].x,m=e[y+1].y-e[y].y,f.x=m*1,f.y=-g,f.z=m*0,p.copy(f),f.x+=x.x,f.y+=x.y,f.z+=x.z,f.normalize(),l.push(f.x,f.y,f.z),x.copy(p)}for(let y=0;y<=t;y++){let S=n+y*h*s,b=Math.sin(S),A=Math.cos(S);for(let R=0;R<=e.length-1;R++){u.x=e[R].x*b,u.y=e[R].y,u.z=e[R].x*A,o.push(u.x,u.y,u.z),d.x=y/t,d.y=R/(e.length-1),a.push(d.x,d.y);let v=l[3*R+0]*b,T=l[3*R+1],D=l[3*R+0]*A;c.push(v,T,D)}}for(let y=0;y<t;y++)for(let S=0;S<e.length-1;S++){let b=S+y*e.length,A=b,R=b+e.length,v=b+e.length+1,T=b+1;r.push(A,R,T),r.push(v,T,R)}this.setIndex(r),this.setAttribute("position",new Ne(o,3)),this.setAttribute("uv",new Ne(a,2)),this.setAttribute("normal",new Ne(c,3))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.points,e.segments,e.phiStart,e.phiLength)}};var Fs=class i extends We{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=e/a,d=t/l,f=[],p=[],x=[],g=[];for(let m=0;m<h;m++){let y=m*d-o;for(let S=0;S<c;S++){let b=S*u-r;p.push(b,-y,0),x.push(0,0,1),g.push(S/a),g.push(1-m/l)}}for(let m=0;m<l;m++)for(let y=0;y<a;y++){let S=y+c*m,b=y+c*(m+1),A=y+1+c*(m+1),R=y+1+c*m;f.push(S,b,R),f.push(b,A,R)}this.setIndex(f),this.setAttribute("position",new Ne(p,3)),this.setAttribute("normal",new Ne(x,3)),this.setAttribute("uv",new Ne(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}},Bs=class i extends We{constructor(e=.5,t=1,n=32,s=1,r=0,o=Math.PI*2){super(),this.type="RingGeometry",this.parameters={innerRadius:e,outerRadius:t,thetaSegments:n,phiSegments:s,thetaStart:r,thetaLength:o},n=Math.max(3,n),s=Math.max(1,s);let a=[],l=[],c=[],h=[],u=e,d=(t-e)/s,f=new E,p=new te;for(let x=0;x<=s;x++){for(let g=0;g<=n;g++){let m=r+g/n*o;f.x=u*Math.cos(m),f.y=u*Math.sin(m),l.push(f.x,f.y,f.z),c.push(0,0,1),p.x=(f.x/t+1)/2,p.y=(f.y/t+1)/2,h.push(p.x,p.y)}u+=d}for(let x=0;x<s;x++){let g=x*(n+1);for(let m=0;m<n;m++){let y=m+g,S=y,b=y+n+1,A=y+n+2,R=y+1;a.push(S,b,R),a.push(b,A,R)}}this.setIndex(a),this.setAttribute("position",new Ne(l,3)),this.setAttribute("normal",new Ne(c,3)),this.setAttribute("uv",new Ne(h,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.innerRadius,e.outerRadius,e.thetaSegments,e.phiSegments,e.thetaStart,e.thetaLength)}},zs=class i extends We{constructor(e=new Li([new te(0,.5),new te(-.5,-.5),new te(.5,-.5)]),t=12){super(),this.type="ShapeGeometry",this.parameters={shapes:e,curveSegments:t};let n=[],s=[],r=[],o=[],a=0,l=0;if(Array.isArray(e)===!1)c(e);else for(let h=0;h<e.length;h++)c(e[h]),this.addGroup(a,l,h),a+=l,l=0;this.setIndex(n),this.setAttribute("position",new Ne(s,3)),this.setAttribute("normal",new Ne(r,3)),this.setAttribute("uv",new Ne(o,2));function c(h){let u=s.length/3,d=h.extractPoints(t),f=d.shape,p=d.holes;Pr.isClockWise(f)===!1&&(f=f.reverse());for(let g=0,m=p.length;g<m;g++){let y=p[g];Pr.isClockWise(y)===!0&&(p[g]=y.reverse())}let x=Pr.triangulateShape(f,p);for(let g=0,m=p.length;g<m;g++){let y=p[g];f=f.concat(y)}for(let g=0,m=f.length;g<m;g++){let y=f[g];s.push(y.x,y.y,0),r.push(0,0,1),o.push(y.x,y.y)}for(let g=0,m=x.length;g<m;g++){let y=x[g],S=y[0]+u,b=y[1]+u,A=y[2]+u;n.push(S,b,A),l+=3}}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}toJSON(){let e=super.toJSON(),t=this.parameters.shapes;return d_(t,e)}static fromJSON(e,t){let n=[];for(let s=0,r=e.shapes.length;s<r;s++){let o=t[e.shapes[s]];n.push(o)}return new i(n,e.curveSegments)}};function d_(i,e){if(e.shapes=[],Array.isArray(i))for(let t=0,n=i.length;t<n;t++){let s=i[t];e.shapes.push(s.uuid)}else e.shapes.push(i.uuid);return e}var Di=class i extends We{constructor(e=1,t=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,h=[],u=new E,d=new E,f=[],p=[],x=[],g=[];for(let m=0;m<=n;m++){let y=[],S=m/n,b=o+S*a,A=e*Math.cos(b),R=Math.sqrt(e*e-A*A),v=0;m===0&&o===0?v=.5/t:m===n&&l===Math.PI&&(v=-.5/t);for(let T=0;T<=t;T++){let D=T/t,P=s+D*r;u.x=-R*Math.cos(P),u.y=A,u.z=R*Math.sin(P),p.push(u.x,u.y,u.z),d.copy(u).normalize(),x.push(d.x,d.y,d.z),g.push(D+v,1-S),y.push(c++)}h.push(y)}for(let m=0;m<n;m++)for(let y=0;y<t;y++){let S=h[m][y+1],b=h[m][y],A=h[m+1][y],R=h[m+1][y+1];(m!==0||o>0)&&f.push(S,b,R),(m!==n-1||l<Math.PI)&&f.push(b,A,R)}this.setIndex(f),this.setAttribute("position",new Ne(p,3)),this.setAttribute("normal",new Ne(x,3)),this.setAttribute("uv",new Ne(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var wa=class extends We{constructor(e=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:e},e!==null){let t=[],n=new Set,s=new E,r=new E;if(e.index!==null){let o=e.attributes.position,a=e.index,l=e.groups;l.length===0&&(l=[{start:0,count:a.count,materialIndex:0}]);for(let c=0,h=l.length;c<h;++c){let u=l[c],d=u.start,f=u.count;for(let p=d,x=d+f;p<x;p+=3)for(let g=0;g<3;g++){let m=a.getX(p+g),y=a.getX(p+(g+1)%3);s.fromBufferAttribute(o,m),r.fromBufferAttribute(o,y),Mg(s,r,n)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}}else{let o=e.attributes.position;for(let a=0,l=o.count/3;a<l;a++)for(let c=0;c<3;c++){let h=3*a+c,u=3*a+(c+1)%3;s.fromBufferAttribute(o,h),r.fromBufferAttribute(o,u),Mg(s,r,n)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}this.setAttribute("position",new Ne(t,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};function Mg(i,e,t){let n=`${i.x},${i.y},${i.z}-${e.x},${e.y},${e.z}`,s=`${e.x},${e.y},${e.z}-${i.x},${i.y},${i.z}`;return t.has(n)===!0||t.has(s)===!0?!1:(t.add(n),t.add(s),!0)}var Ma=class extends Sn{constructor(e){super(),this.isShadowMaterial=!0,this.type="ShadowMaterial",this.color=new Re(0),this.transparent=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.fog=e.fog,this}};function qs(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(Sg(s))s.isRenderTargetTexture?(De("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(Sg(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function un(i){let e={};for(let t=0;t<i.length;t++){let n=qs(i[t]);for(let s in n)e[s]=n[s]}return e}function Sg(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function f_(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function zf(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:it.workingColorSpace}var Wa={clone:qs,merge:un},p_=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,m_=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,$n=class extends Sn{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=p_,this.fragmentShader=m_,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=qs(e.uniforms),this.uniformsGroups=f_(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new Re().setHex(s.value);break;case"v2":this.uniforms[n].value=new te().fromArray(s.value);break;case"v3":this.uniforms[n].value=new E().fromArray(s.value);break;case"v4":this.uniforms[n].value=new ft().fromArray(s.value);break;case"m3":this.uniforms[n].value=new He().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Le().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Oc=class extends $n{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},Sa=class extends Sn{constructor(e){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new Re(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Re(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Jr,this.normalScale=new te(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ti,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var Ta=class extends Sn{constructor(e){super(),this.isMeshPhongMaterial=!0,this.type="MeshPhongMaterial",this.color=new Re(16777215),this.specular=new Re(1118481),this.shininess=30,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Re(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Jr,this.normalScale=new te(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ti,this.combine=Oa,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.specular.copy(e.specular),this.shininess=e.shininess,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var On=class extends Sn{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Re(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Re(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Jr,this.normalScale=new te(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ti,this.combine=Oa,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},Uc=class extends Sn{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=i0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Fc=class extends Sn{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Mr(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function lc(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var is=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Bc=class extends is{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Kd,endingEnd:Kd}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Jd:r=e,a=2*t-n;break;case Qd:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Jd:o=e,l=2*n-t;break;case Qd:o=1,l=n+s[1]-s[0];break;default:o=e-1,l=t}let c=(n-t)*.5,h=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(n-t)/(s-t),x=p*p,g=x*p,m=-d*g+2*d*x-d*p,y=(1+d)*g+(-1.5-2*d)*x+(-.5+d)*p+1,S=(-1-f)*g+(1.5+f)*x+.5*p,b=f*g-f*x;for(let A=0;A!==a;++A)r[A]=m*o[h+A]+y*o[c+A]+S*o[l+A]+b*o[u+A];return r}},zc=class extends is{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=(n-t)/(s-t),u=1-h;for(let d=0;d!==a;++d)r[d]=o[c+d]*u+o[l+d]*h;return r}},Vc=class extends is{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Gc=class extends is{interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let p=(n-t)/(s-t),x=1-p;for(let g=0;g!==a;++g)r[g]=o[c+g]*x+o[l+g]*p;return r}let d=a*2,f=e-1;for(let p=0;p!==a;++p){let x=o[c+p],g=o[l+p],m=f*d+p*2,y=u[m],S=u[m+1],b=e*d+p*2,A=h[b],R=h[b+1],v=x_(n,t,y,A,s);r[p]=_0(v,x,S,R,g)}return r}};function _0(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function g_(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function x_(i,e,t,n,s){let r=(i-e)/(s-e);for(let o=0;o<8;o++){let a=_0(r,e,t,n,s)-i;if(Math.abs(a)<1e-10)break;let l=g_(r,e,t,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Un=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Mr(t,this.TimeBufferType),this.values=Mr(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:Mr(e.times,Array),values:Mr(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),lc(e.settings)&&(n.settings={inTangents:Mr(e.settings.inTangents,Array),outTangents:Mr(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new Vc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new zc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Bc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Gc(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Zo:t=this.InterpolantFactoryMethodDiscrete;break;case wc:t=this.InterpolantFactoryMethodLinear;break;case dc:t=this.InterpolantFactoryMethodSmooth;break;case jd:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return De("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Zo;case this.InterpolantFactoryMethodLinear:return wc;case this.InterpolantFactoryMethodSmooth:return dc;case this.InterpolantFactoryMethodBezier:return jd}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;lc(this.settings)&&(Tg(this.settings.inTangents,e),Tg(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;lc(this.settings)&&(Eg(this.settings.inTangents,e),Eg(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(Ve("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(Ve("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){Ve("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){Ve("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&ab(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){Ve("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===dc,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],h=e[a+1];if(c!==h&&(a!==1||c!==e[0]))if(s)l=!0;else{let u=a*n,d=u-n,f=u+n;for(let p=0;p!==n;++p){let x=t[u+p];if(x!==t[d+p]||x!==t[f+p]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let u=a*n,d=o*n;for(let f=0;f!==n;++f)t[d+f]=t[u+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,lc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Tg(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function Eg(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}Un.prototype.ValueTypeName="";Un.prototype.TimeBufferType=Float32Array;Un.prototype.ValueBufferType=Float32Array;Un.prototype.DefaultInterpolation=wc;var ss=class extends Un{constructor(e,t,n){super(e,t,n)}};ss.prototype.ValueTypeName="bool";ss.prototype.ValueBufferType=Array;ss.prototype.DefaultInterpolation=Zo;ss.prototype.InterpolantFactoryMethodLinear=void 0;ss.prototype.InterpolantFactoryMethodSmooth=void 0;var Hc=class extends Un{constructor(e,t,n,s){super(e,t,n,s)}};Hc.prototype.ValueTypeName="color";var Wc=class extends Un{constructor(e,t,n,s){super(e,t,n,s)}};Wc.prototype.ValueTypeName="number";var $c=class extends is{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(s-t),c=e*a;for(let h=c+a;c!==h;c+=4)Rt.slerpFlat(r,0,o,c-a,o,c,l);return r}},Ea=class extends Un{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new $c(this.times,this.values,this.getValueSize(),e)}};Ea.prototype.ValueTypeName="quaternion";Ea.prototype.InterpolantFactoryMethodSmooth=void 0;var rs=class extends Un{constructor(e,t,n){super(e,t,n)}};rs.prototype.ValueTypeName="string";rs.prototype.ValueBufferType=Array;rs.prototype.DefaultInterpolation=Zo;rs.prototype.InterpolantFactoryMethodLinear=void 0;rs.prototype.InterpolantFactoryMethodSmooth=void 0;var Xc=class extends Un{constructor(e,t,n,s){super(e,t,n,s)}};Xc.prototype.ValueTypeName="vector";var qc=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=c.length;u<d;u+=2){let f=c[u],p=c[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},w0=new qc,Yc=class{constructor(e){this.manager=e!==void 0?e:w0,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Yc.DEFAULT_MATERIAL_NAME="__DEFAULT";var $r=class extends Nt{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new Re(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},Aa=class extends $r{constructor(e,t,n){super(e,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Nt.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Re(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},Yd=new Le,Ag=new E,Rg=new E,Zc=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new te(512,512),this.mapType=Tn,this.map=null,this.mapPass=null,this.matrix=new Le,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new es,this._frameExtents=new te(1,1),this._viewportCount=1,this._viewports=[new ft(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;Ag.setFromMatrixPosition(e.matrixWorld),t.position.copy(Ag),Rg.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(Rg),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,s){Yd.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(Yd,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===Dr||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(Yd)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},cc=new E,hc=new Rt,hi=new E,Ra=class extends Nt{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Le,this.projectionMatrix=new Le,this.projectionMatrixInverse=new Le,this.coordinateSystem=Wn,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(cc,hc,hi),hi.x===1&&hi.y===1&&hi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(cc,hc,hi.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(cc,hc,hi),hi.x===1&&hi.y===1&&hi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(cc,hc,hi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Qi=new E,Cg=new te,Pg=new te,pn=class extends Ra{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=kr*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Rr*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return kr*2*Math.atan(Math.tan(Rr*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){Qi.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Qi.x,Qi.y).multiplyScalar(-e/Qi.z),Qi.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Qi.x,Qi.y).multiplyScalar(-e/Qi.z)}getViewSize(e,t){return this.getViewBounds(e,Cg,Pg),t.subVectors(Pg,Cg)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Rr*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Ca=class extends Ra{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},rf=class extends Zc{constructor(){super(new Ca(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Pa=class extends $r{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Nt.DEFAULT_UP),this.updateMatrix(),this.target=new Nt,this.shadow=new rf}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}},Ia=class extends $r{constructor(e,t){super(e,t),this.isAmbientLight=!0,this.type="AmbientLight"}};var La=class extends We{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var Sr=-90,Tr=1,Xr=class extends Nt{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new pn(Sr,Tr,e,t);s.layers=this.layers,this.add(s);let r=new pn(Sr,Tr,e,t);r.layers=this.layers,this.add(r);let o=new pn(Sr,Tr,e,t);o.layers=this.layers,this.add(o);let a=new pn(Sr,Tr,e,t);a.layers=this.layers,this.add(a);let l=new pn(Sr,Tr,e,t);l.layers=this.layers,this.add(l);let c=new pn(Sr,Tr,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Wn)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Dr)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=!1;let x=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let g=!1;e.isWebGLRenderer===!0?g=e.state.buffers.depth.getReversed():g=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,2,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=x,e.setRenderTarget(n,5,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(u,d,f),e.xr.enabled=p,n.texture.needsPMREMUpdate=!0}},jc=class extends pn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Vf="\\[\\]\\.:\\/",y_=new RegExp("["+Vf+"]","g"),Gf="[^"+Vf+"]",v_="[^"+Vf.replace("\\.","")+"]",b_=/((?:WC+[\/:])*)/.source.replace("WC",Gf),__=/(WCOD+)?/.source.replace("WCOD",v_),w_=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Gf),M_=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Gf),S_=new RegExp("^"+b_+__+w_+M_+"$"),T_=["material","materials","bones","map"],of=class{constructor(e,t,n){let s=n||bt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},bt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(y_,"")}static parseTrackName(e){let t=S_.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);T_.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){De("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){Ve("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){Ve("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){Ve("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){Ve("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){Ve("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){Ve("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){Ve("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;Ve("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){Ve("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){Ve("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};bt.Composite=of;bt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};bt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};bt.prototype.GetterByBindingType=[bt.prototype._getValue_direct,bt.prototype._getValue_array,bt.prototype._getValue_arrayElement,bt.prototype._getValue_toArray];bt.prototype.SetterByBindingTypeAndVersioning=[[bt.prototype._setValue_direct,bt.prototype._setValue_direct_setNeedsUpdate,bt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[bt.prototype._setValue_array,bt.prototype._setValue_array_setNeedsUpdate,bt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[bt.prototype._setValue_arrayElement,bt.prototype._setValue_arrayElement_setNeedsUpdate,bt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[bt.prototype._setValue_fromArray,bt.prototype._setValue_fromArray_setNeedsUpdate,bt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var nP=new Float32Array(1);var os=class extends Fr{constructor(e,t,n=1){super(e,t),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=n}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}clone(e){let t=super.clone(e);return t.meshPerAttribute=this.meshPerAttribute,t}toJSON(e){let t=super.toJSON(e);return t.isInstancedInterleavedBuffer=!0,t.meshPerAttribute=this.meshPerAttribute,t}};var qr=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=Ge(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(Ge(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var af=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}},Ig=new te,Vs=class{constructor(e=new te(1/0,1/0),t=new te(-1/0,-1/0)){this.isBox2=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Ig.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=1/0,this.max.x=this.max.y=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y}getCenter(e){return this.isEmpty()?e.set(0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Ig).distanceTo(e)}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}},Lg=new E,uc=new E,Er=new E,Ar=new E,Zd=new E,E_=new E,A_=new E,Da=class{constructor(e=new E,t=new E){this.start=e,this.end=t}set(e,t){return this.start.copy(e),this.end.copy(t),this}copy(e){return this.start.copy(e.start),this.end.copy(e.end),this}getCenter(e){return e.addVectors(this.start,this.end).multiplyScalar(.5)}delta(e){return e.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(e,t){return this.delta(t).multiplyScalar(e).add(this.start)}closestPointToPointParameter(e,t){Lg.subVectors(e,this.start),uc.subVectors(this.end,this.start);let n=uc.dot(uc);if(n===0)return 0;let r=uc.dot(Lg)/n;return t&&(r=Ge(r,0,1)),r}closestPointToPoint(e,t,n){let s=this.closestPointToPointParameter(e,t);return this.delta(n).multiplyScalar(s).add(this.start)}distanceSqToLine3(e,t=E_,n=A_){let s=10000000000000001e-32,r,o,a=this.start,l=e.start,c=this.end,h=e.end;Er.subVectors(c,a),Ar.subVectors(h,l),Zd.subVectors(a,l);let u=Er.dot(Er),d=Ar.dot(Ar),f=Ar.dot(Zd);if(u<=s&&d<=s)return t.copy(a),n.copy(l),t.distanceToSquared(n);if(u<=s)r=0,o=f/d,o=Ge(o,0,1);else{let p=Er.dot(Zd);if(d<=s)o=0,r=Ge(-p/u,0,1);else{let x=Er.dot(Ar),g=u*d-x*x;g!==0?r=Ge((x*f-p*d)/g,0,1):r=0,o=(x*r+f)/d,o<0?(o=0,r=Ge(-p/u,0,1)):o>1&&(o=1,r=Ge((x-p)/u,0,1))}}return t.copy(a).addScaledVector(Er,r),n.copy(l).addScaledVector(Ar,o),t.distanceToSquared(n)}applyMatrix4(e){return this.start.applyMatrix4(e),this.end.applyMatrix4(e),this}equals(e){return e.start.equals(this.start)&&e.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var Na=class extends Vr{constructor(e=10,t=10,n=4473924,s=8947848){n=new Re(n),s=new Re(s);let r=t/2,o=e/t,a=e/2,l=[],c=[];for(let d=0,f=0,p=-a;d<=t;d++,p+=o){l.push(-a,0,p,a,0,p),l.push(p,0,-a,p,0,a);let x=d===r?n:s;x.toArray(c,f),f+=3,x.toArray(c,f),f+=3,x.toArray(c,f),f+=3,x.toArray(c,f),f+=3}let h=new We;h.setAttribute("position",new Ne(l,3)),h.setAttribute("color",new Ne(c,3));let u=new Ds({vertexColors:!0,toneMapped:!1});super(h,u),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var ka=class extends ei{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Hf(i,e,t,n){let s=R_(n);switch(t){case Ef:return i*e;case ih:return i*e/s.components*s.byteLength;case sh:return i*e/s.components*s.byteLength;case hs:return i*e*2/s.components*s.byteLength;case rh:return i*e*2/s.components*s.byteLength;case Af:return i*e*3/s.components*s.byteLength;case si:return i*e*4/s.components*s.byteLength;case oh:return i*e*4/s.components*s.byteLength;case Fa:case Ba:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case za:case Va:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case lh:case hh:return Math.max(i,16)*Math.max(e,8)/4;case ah:case ch:return Math.max(i,8)*Math.max(e,8)/2;case uh:case dh:case ph:case mh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case fh:case Ga:case gh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case xh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case yh:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case vh:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case bh:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case _h:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case wh:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case Mh:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case Sh:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case Th:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case Eh:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case Ah:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case Rh:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case Ch:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case Ph:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case Ih:case Lh:case Dh:return Math.ceil(i/4)*Math.ceil(e/4)*16;case Nh:case kh:return Math.ceil(i/4)*Math.ceil(e/4)*8;case Ha:case Oh:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function R_(i){switch(i){case Tn:case wf:return{byteLength:1,components:1};case Kr:case Mf:case ii:return{byteLength:2,components:1};case th:case nh:return{byteLength:2,components:4};case ni:case eh:case Xn:return{byteLength:4,components:1};case Sf:case Tf:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?De("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */function W0(){let i=null,e=!1,t=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function D_(i){let e=new WeakMap;function t(a,l){let c=a.array,h=a.usage,u=c.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,c,h),a.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){let h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<u.length;f++){let p=u[d],x=u[f];x.start<=p.start+p.count+1?p.count=Math.max(p.count,x.start+x.count-p.start):(++d,u[d]=x)}u.length=d+1;for(let f=0,p=u.length;f<p;f++){let x=u[f];i.bufferSubData(c,x.start*h.BYTES_PER_ELEMENT,h,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var N_=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,k_=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,O_=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,U_=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,F_=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,B_=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,z_=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,V_=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,G_=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,H_=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,W_=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,$_=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,X_=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,q_=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,Y_=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,Z_=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,j_=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,K_=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,J_=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Q_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,ew=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,tw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,nw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,iw=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,sw=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,rw=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,ow=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,aw=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,lw=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,cw="gl_FragColor = linearToOutputTexel( gl_FragColor );",hw=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,uw=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,dw=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,fw=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,pw=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,mw=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,gw=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,xw=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,yw=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,vw=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,bw=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,_w=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,ww=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Mw=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Sw=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,Tw=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,Ew=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Aw=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Rw=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Cw=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Pw=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,Iw=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Lw=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,Dw=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Nw=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,kw=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,Ow=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Uw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Fw=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Bw=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,zw=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Vw=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Gw=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,Hw=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Ww=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,$w=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Xw=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,qw=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Yw=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Zw=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,jw=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Kw=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,Jw=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,Qw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,eM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,tM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,nM=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,iM=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,sM=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,rM=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,oM=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,aM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,lM=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,cM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,hM=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,uM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,dM=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,fM=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,pM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,mM=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,gM=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,xM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,yM=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,vM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,bM=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,_M=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,wM=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,MM=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,SM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,TM=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,EM=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,AM=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,RM=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,CM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,PM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,IM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,LM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,DM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,NM=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,kM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,OM=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,UM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,FM=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,BM=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,zM=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,VM=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,GM=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,HM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,WM=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,$M=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,XM=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,qM=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,YM=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,ZM=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,jM=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,KM=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,JM=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,QM=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,eS=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,tS=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,nS=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,iS=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,sS=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,rS=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,oS=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,aS=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,lS=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,cS=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,hS=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,uS=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,dS=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,Qe={alphahash_fragment:N_,alphahash_pars_fragment:k_,alphamap_fragment:O_,alphamap_pars_fragment:U_,alphatest_fragment:F_,alphatest_pars_fragment:B_,aomap_fragment:z_,aomap_pars_fragment:V_,batching_pars_vertex:G_,batching_vertex:H_,begin_vertex:W_,beginnormal_vertex:$_,bsdfs:X_,iridescence_fragment:q_,bumpmap_pars_fragment:Y_,clipping_planes_fragment:Z_,clipping_planes_pars_fragment:j_,clipping_planes_pars_vertex:K_,clipping_planes_vertex:J_,color_fragment:Q_,color_pars_fragment:ew,color_pars_vertex:tw,color_vertex:nw,common:iw,defaultnormal_vertex:sw,displacementmap_pars_vertex:rw,displacementmap_vertex:ow,emissivemap_fragment:aw,emissivemap_pars_fragment:lw,colorspace_fragment:cw,colorspace_pars_fragment:hw,envmap_fragment:uw,envmap_common_pars_fragment:dw,envmap_pars_fragment:fw,envmap_pars_vertex:pw,envmap_physical_pars_fragment:Tw,envmap_vertex:mw,fog_vertex:gw,fog_pars_vertex:xw,fog_fragment:yw,fog_pars_fragment:vw,gradientmap_pars_fragment:bw,lightmap_pars_fragment:_w,lights_lambert_fragment:ww,lights_lambert_pars_fragment:Mw,lights_pars_begin:Sw,lights_toon_fragment:Ew,lights_toon_pars_fragment:Aw,lights_phong_fragment:Rw,lights_phong_pars_fragment:Cw,lights_physical_fragment:Pw,lights_physical_pars_fragment:Iw,lights_fragment_begin:Lw,lights_fragment_maps:Dw,lights_fragment_end:Nw,lightprobes_pars_fragment:kw,logdepthbuf_fragment:Ow,logdepthbuf_pars_fragment:Uw,logdepthbuf_pars_vertex:Fw,logdepthbuf_vertex:Bw,map_fragment:zw,map_pars_fragment:Vw,map_particle_fragment:Gw,map_particle_pars_fragment:Hw,metalnessmap_fragment:Ww,metalnessmap_pars_fragment:$w,morphinstance_vertex:Xw,morphcolor_vertex:qw,morphnormal_vertex:Yw,morphtarget_pars_vertex:Zw,morphtarget_vertex:jw,normal_fragment_begin:Kw,normal_fragment_maps:Jw,normal_pars_fragment:Qw,normal_pars_vertex:eM,normal_vertex:tM,normalmap_pars_fragment:nM,clearcoat_normal_fragment_begin:iM,clearcoat_normal_fragment_maps:sM,clearcoat_pars_fragment:rM,iridescence_pars_fragment:oM,opaque_fragment:aM,packing:lM,premultiplied_alpha_fragment:cM,project_vertex:hM,dithering_fragment:uM,dithering_pars_fragment:dM,roughnessmap_fragment:fM,roughnessmap_pars_fragment:pM,shadowmap_pars_fragment:mM,shadowmap_pars_vertex:gM,shadowmap_vertex:xM,shadowmask_pars_fragment:yM,skinbase_vertex:vM,skinning_pars_vertex:bM,skinning_vertex:_M,skinnormal_vertex:wM,specularmap_fragment:MM,specularmap_pars_fragment:SM,tonemapping_fragment:TM,tonemapping_pars_fragment:EM,transmission_fragment:AM,transmission_pars_fragment:RM,uv_pars_fragment:CM,uv_pars_vertex:PM,uv_vertex:IM,worldpos_vertex:LM,background_vert:DM,background_frag:NM,backgroundCube_vert:kM,backgroundCube_frag:OM,cube_vert:UM,cube_frag:FM,depth_vert:BM,depth_frag:zM,distance_vert:VM,distance_frag:GM,equirect_vert:HM,equirect_frag:WM,linedashed_vert:$M,linedashed_frag:XM,meshbasic_vert:qM,meshbasic_frag:YM,meshlambert_vert:ZM,meshlambert_frag:jM,meshmatcap_vert:KM,meshmatcap_frag:JM,meshnormal_vert:QM,meshnormal_frag:eS,meshphong_vert:tS,meshphong_frag:nS,meshphysical_vert:iS,meshphysical_frag:sS,meshtoon_vert:rS,meshtoon_frag:oS,points_vert:aS,points_frag:lS,shadow_vert:cS,shadow_frag:hS,sprite_vert:uS,sprite_frag:dS},pe={common:{diffuse:{value:new Re(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new He},alphaMap:{value:null},alphaMapTransform:{value:new He},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new He}},envmap:{envMap:{value:null},envMapRotation:{value:new He},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new He}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new He}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new He},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new He},normalScale:{value:new te(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new He},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new He}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new He}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new He}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Re(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Re(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new He},alphaTest:{value:0},uvTransform:{value:new He}},sprite:{diffuse:{value:new Re(16777215)},opacity:{value:1},center:{value:new te(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new He},alphaMap:{value:null},alphaMapTransform:{value:new He},alphaTest:{value:0}}},yn={basic:{uniforms:un([pe.common,pe.specularmap,pe.envmap,pe.aomap,pe.lightmap,pe.fog]),vertexShader:Qe.meshbasic_vert,fragmentShader:Qe.meshbasic_frag},lambert:{uniforms:un([pe.common,pe.specularmap,pe.envmap,pe.aomap,pe.lightmap,pe.emissivemap,pe.bumpmap,pe.normalmap,pe.displacementmap,pe.fog,pe.lights,{emissive:{value:new Re(0)},envMapIntensity:{value:1}}]),vertexShader:Qe.meshlambert_vert,fragmentShader:Qe.meshlambert_frag},phong:{uniforms:un([pe.common,pe.specularmap,pe.envmap,pe.aomap,pe.lightmap,pe.emissivemap,pe.bumpmap,pe.normalmap,pe.displacementmap,pe.fog,pe.lights,{emissive:{value:new Re(0)},specular:{value:new Re(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Qe.meshphong_vert,fragmentShader:Qe.meshphong_frag},standard:{uniforms:un([pe.common,pe.envmap,pe.aomap,pe.lightmap,pe.emissivemap,pe.bumpmap,pe.normalmap,pe.displacementmap,pe.roughnessmap,pe.metalnessmap,pe.fog,pe.lights,{emissive:{value:new Re(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Qe.meshphysical_vert,fragmentShader:Qe.meshphysical_frag},toon:{uniforms:un([pe.common,pe.aomap,pe.lightmap,pe.emissivemap,pe.bumpmap,pe.normalmap,pe.displacementmap,pe.gradientmap,pe.fog,pe.lights,{emissive:{value:new Re(0)}}]),vertexShader:Qe.meshtoon_vert,fragmentShader:Qe.meshtoon_frag},matcap:{uniforms:un([pe.common,pe.bumpmap,pe.normalmap,pe.displacementmap,pe.fog,{matcap:{value:null}}]),vertexShader:Qe.meshmatcap_vert,fragmentShader:Qe.meshmatcap_frag},points:{uniforms:un([pe.points,pe.fog]),vertexShader:Qe.points_vert,fragmentShader:Qe.points_frag},dashed:{uniforms:un([pe.common,pe.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Qe.linedashed_vert,fragmentShader:Qe.linedashed_frag},depth:{uniforms:un([pe.common,pe.displacementmap]),vertexShader:Qe.depth_vert,fragmentShader:Qe.depth_frag},normal:{uniforms:un([pe.common,pe.bumpmap,pe.normalmap,pe.displacementmap,{opacity:{value:1}}]),vertexShader:Qe.meshnormal_vert,fragmentShader:Qe.meshnormal_frag},sprite:{uniforms:un([pe.sprite,pe.fog]),vertexShader:Qe.sprite_vert,fragmentShader:Qe.sprite_frag},background:{uniforms:{uvTransform:{value:new He},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Qe.background_vert,fragmentShader:Qe.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new He}},vertexShader:Qe.backgroundCube_vert,fragmentShader:Qe.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Qe.cube_vert,fragmentShader:Qe.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Qe.equirect_vert,fragmentShader:Qe.equirect_frag},distance:{uniforms:un([pe.common,pe.displacementmap,{referencePosition:{value:new E},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Qe.distance_vert,fragmentShader:Qe.distance_frag},shadow:{uniforms:un([pe.lights,pe.fog,{color:{value:new Re(0)},opacity:{value:1}}]),vertexShader:Qe.shadow_vert,fragmentShader:Qe.shadow_frag}};yn.physical={uniforms:un([yn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new He},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new He},clearcoatNormalScale:{value:new te(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new He},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new He},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new He},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new He},sheen:{value:0},sheenColor:{value:new Re(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new He},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new He},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new He},transmissionSamplerSize:{value:new te},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new He},attenuationDistance:{value:0},attenuationColor:{value:new Re(0)},specularColor:{value:new Re(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new He},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new He},anisotropyVector:{value:new te},anisotropyMap:{value:null},anisotropyMapTransform:{value:new He}}]),vertexShader:Qe.meshphysical_vert,fragmentShader:Qe.meshphysical_frag};var Fh={r:0,b:0,g:0},fS=new Le,$0=new He;$0.set(-1,0,0,0,1,0,0,0,1);function pS(i,e,t,n,s,r){let o=new Re(0),a=s===!0?0:1,l,c,h=null,u=0,d=null;function f(y){let S=y.isScene===!0?y.background:null;if(S&&S.isTexture){let b=y.backgroundBlurriness>0;S=e.get(S,b)}return S}function p(y){let S=!1,b=f(y);b===null?g(o,a):b&&b.isColor&&(g(b,1),S=!0);let A=i.xr.getEnvironmentBlendMode();A==="additive"?t.buffers.color.setClear(0,0,0,1,r):A==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||S)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function x(y,S){let b=f(S);b&&b.isCubeTexture?(c===void 0&&(c=new st(new Nn(1,1,1),new $n({name:"BackgroundCubeMaterial",uniforms:qs(yn.backgroundCube.uniforms),vertexShader:yn.backgroundCube.vertexShader,fragmentShader:yn.backgroundCube.fragmentShader,side:xn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(A,R,v){this.matrixWorld.copyPosition(v.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=S.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(fS.makeRotationFromEuler(S.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply($0),c.material.toneMapped=it.getTransfer(b.colorSpace)!==dt,(h!==b||u!==b.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=b,u=b.version,d=i.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new st(new Fs(2,2),new $n({name:"BackgroundMaterial",uniforms:qs(yn.background.uniforms),vertexShader:yn.background.vertexShader,fragmentShader:yn.background.fragmentShader,side:cs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,l.material.toneMapped=it.getTransfer(b.colorSpace)!==dt,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(h!==b||u!==b.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,h=b,u=b.version,d=i.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null))}function g(y,S){y.getRGB(Fh,zf(i)),t.buffers.color.setClear(Fh.r,Fh.g,Fh.b,S,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(y,S=1){o.set(y),a=S,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(y){a=y,g(o,a)},render:p,addToRenderList:x,dispose:m}}function mS(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,o=!1;function a(k,O,z,I,H){let X=!1,G=u(k,I,z,O);r!==G&&(r=G,c(r.object)),X=f(k,I,z,H),X&&p(k,I,z,H),H!==null&&e.update(H,i.ELEMENT_ARRAY_BUFFER),(X||o)&&(o=!1,b(k,O,z,I),H!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(H).buffer))}function l(){return i.createVertexArray()}function c(k){return i.bindVertexArray(k)}function h(k){return i.deleteVertexArray(k)}function u(k,O,z,I){let H=I.wireframe===!0,X=n[O.id];X===void 0&&(X={},n[O.id]=X);let G=k.isInstancedMesh===!0?k.id:0,ne=X[G];ne===void 0&&(ne={},X[G]=ne);let $=ne[z.id];$===void 0&&($={},ne[z.id]=$);let J=$[H];return J===void 0&&(J=d(l()),$[H]=J),J}function d(k){let O=[],z=[],I=[];for(let H=0;H<t;H++)O[H]=0,z[H]=0,I[H]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:O,enabledAttributes:z,attributeDivisors:I,object:k,attributes:{},index:null}}function f(k,O,z,I){let H=r.attributes,X=O.attributes,G=0,ne=z.getAttributes();for(let $ in ne)if(ne[$].location>=0){let ee=H[$],we=X[$];if(we===void 0&&($==="instanceMatrix"&&k.instanceMatrix&&(we=k.instanceMatrix),$==="instanceColor"&&k.instanceColor&&(we=k.instanceColor)),ee===void 0||ee.attribute!==we||we&&ee.data!==we.data)return!0;G++}return r.attributesNum!==G||r.index!==I}function p(k,O,z,I){let H={},X=O.attributes,G=0,ne=z.getAttributes();for(let $ in ne)if(ne[$].location>=0){let ee=X[$];ee===void 0&&($==="instanceMatrix"&&k.instanceMatrix&&(ee=k.instanceMatrix),$==="instanceColor"&&k.instanceColor&&(ee=k.instanceColor));let we={};we.attribute=ee,ee&&ee.data&&(we.data=ee.data),H[$]=we,G++}r.attributes=H,r.attributesNum=G,r.index=I}function x(){let k=r.newAttributes;for(let O=0,z=k.length;O<z;O++)k[O]=0}function g(k){m(k,0)}function m(k,O){let z=r.newAttributes,I=r.enabledAttributes,H=r.attributeDivisors;z[k]=1,I[k]===0&&(i.enableVertexAttribArray(k),I[k]=1),H[k]!==O&&(i.vertexAttribDivisor(k,O),H[k]=O)}function y(){let k=r.newAttributes,O=r.enabledAttributes;for(let z=0,I=O.length;z<I;z++)O[z]!==k[z]&&(i.disableVertexAttribArray(z),O[z]=0)}function S(k,O,z,I,H,X,G){G===!0?i.vertexAttribIPointer(k,O,z,H,X):i.vertexAttribPointer(k,O,z,I,H,X)}function b(k,O,z,I){x();let H=I.attributes,X=z.getAttributes(),G=O.defaultAttributeValues;for(let ne in X){let $=X[ne];if($.location>=0){let J=H[ne];if(J===void 0&&(ne==="instanceMatrix"&&k.instanceMatrix&&(J=k.instanceMatrix),ne==="instanceColor"&&k.instanceColor&&(J=k.instanceColor)),J!==void 0){let ee=J.normalized,we=J.itemSize,ke=e.get(J);if(ke===void 0)continue;let Z=ke.buffer,xe=ke.type,Te=ke.bytesPerElement,Oe=xe===i.INT||xe===i.UNSIGNED_INT||J.gpuType===eh;if(J.isInterleavedBufferAttribute){let ve=J.data,Ze=ve.isInterleavedBuffer===!0?ve.stride:ve.itemSize,Ct=J.offset;if(ve.isInstancedInterleavedBuffer||ve.isInstancedBufferAttribute){for(let Fe=0;Fe<$.locationSize;Fe++)m($.location+Fe,ve.meshPerAttribute);k.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=ve.meshPerAttribute*ve.count)}else for(let Fe=0;Fe<$.locationSize;Fe++)g($.location+Fe);i.bindBuffer(i.ARRAY_BUFFER,Z);for(let Fe=0;Fe<$.locationSize;Fe++)S($.location+Fe,we/$.locationSize,xe,ee,Ze*Te,(Ct+we/$.locationSize*Fe)*Te,Oe)}else{if(J.isInstancedBufferAttribute){for(let ve=0;ve<$.locationSize;ve++)m($.location+ve,J.meshPerAttribute);k.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=J.meshPerAttribute*J.count)}else for(let ve=0;ve<$.locationSize;ve++)g($.location+ve);i.bindBuffer(i.ARRAY_BUFFER,Z);for(let ve=0;ve<$.locationSize;ve++)S($.location+ve,we/$.locationSize,xe,ee,we*Te,we/$.locationSize*ve*Te,Oe)}}else if(G!==void 0){let ee=G[ne];if(ee!==void 0)switch(ee.length){case 2:i.vertexAttrib2fv($.location,ee);break;case 3:i.vertexAttrib3fv($.location,ee);break;case 4:i.vertexAttrib4fv($.location,ee);break;default:i.vertexAttrib1fv($.location,ee)}}}}y()}function A(){D();for(let k in n){let O=n[k];for(let z in O){let I=O[z];for(let H in I){let X=I[H];for(let G in X)h(X[G].object),delete X[G];delete I[H]}}delete n[k]}}function R(k){if(n[k.id]===void 0)return;let O=n[k.id];for(let z in O){let I=O[z];for(let H in I){let X=I[H];for(let G in X)h(X[G].object),delete X[G];delete I[H]}}delete n[k.id]}function v(k){for(let O in n){let z=n[O];for(let I in z){let H=z[I];if(H[k.id]===void 0)continue;let X=H[k.id];for(let G in X)h(X[G].object),delete X[G];delete H[k.id]}}}function T(k){for(let O in n){let z=n[O],I=k.isInstancedMesh===!0?k.id:0,H=z[I];if(H!==void 0){for(let X in H){let G=H[X];for(let ne in G)h(G[ne].object),delete G[ne];delete H[X]}delete z[I],Object.keys(z).length===0&&delete n[O]}}}function D(){P(),o=!0,r!==s&&(r=s,c(r.object))}function P(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:D,resetDefaultState:P,dispose:A,releaseStatesOfGeometry:R,releaseStatesOfObject:T,releaseStatesOfProgram:v,initAttributes:x,enableAttribute:g,disableUnusedAttributes:y}}function gS(i,e,t){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),t.update(c,n,h))}function a(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let d=0;for(let f=0;f<h;f++)d+=c[f];t.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function xS(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let v=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(v.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(v){return!(v!==si&&n.convert(v)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(v){let T=v===ii&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(v!==Tn&&v!==Xn&&!T&&n.convert(v)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(v){if(v==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";v="mediump"}return v==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(De("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&u===!1;t.reversedDepthBuffer===!0&&u===!1&&De("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&u===!0&&De("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),p=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=i.getParameter(i.MAX_TEXTURE_SIZE),g=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),m=i.getParameter(i.MAX_VERTEX_ATTRIBS),y=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),S=i.getParameter(i.MAX_VARYING_VECTORS),b=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),A=i.getParameter(i.MAX_SAMPLES),R=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:p,maxTextureSize:x,maxCubemapSize:g,maxAttributes:m,maxVertexUniforms:y,maxVaryings:S,maxFragmentUniforms:b,maxSamples:A,samples:R}}function yS(i){let e=this,t=null,n=0,s=!1,r=!1,o=new Ln,a=new He,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||n!==0||s;return s=d,n=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){t=h(u,d,0)},this.setState=function(u,d,f){let p=u.clippingPlanes,x=u.clipIntersection,g=u.clipShadows,m=i.get(u);if(!s||p===null||p.length===0||r&&!g)r?h(null):c();else{let y=r?0:n,S=y*4,b=m.clippingState||null;l.value=b,b=h(p,d,S,f);for(let A=0;A!==S;++A)b[A]=t[A];m.clippingState=b,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function h(u,d,f,p){let x=u!==null?u.length:0,g=null;if(x!==0){if(g=l.value,p!==!0||g===null){let m=f+x*4,y=d.matrixWorldInverse;a.getNormalMatrix(y),(g===null||g.length<m)&&(g=new Float32Array(m));for(let S=0,b=f;S!==x;++S,b+=4)o.copy(u[S]).applyMatrix4(y,a),o.normal.toArray(g,b),g[b+3]=o.constant}l.value=g,l.needsUpdate=!0}return e.numPlanes=x,e.numIntersection=0,g}}var qa=class extends Dn{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new ca(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Nn(5,5,5),r=new $n({name:"CubemapFromEquirect",uniforms:qs(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:xn,blending:Hs});r.uniforms.tEquirect.value=t;let o=new st(s,r),a=t.minFilter;return t.minFilter===Ni&&(t.minFilter=mn),new Xr(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},M0=256,vS=3,bS=20,X0=256,q0=16,_S=3,wS=new E,MS=new Re,zh=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Xr(1,10,null),this._boxMesh=new st(new Nn(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=wS}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,x=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(e.background=l.getClearColor(MS));let g=new Xr(n,s,h);return g.position.copy(a),g.update(l,e),l.autoClear=u,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=p,e.background=x,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=E0(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=T0(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(M0,Of(e))}_fromTexture(e,t){e.mapping===$s||e.mapping===jr?this._setSize(e.image.length===0?M0:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=S0(e,!1,!1),n=Math.log2(e)-vS;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=S0(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===$s||e.mapping===jr?(this._cubemapMaterial===null&&(this._cubemapMaterial=E0()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=T0()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=SS(),this._integrationMaterial=TS());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/q0);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-_S)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(X0*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=ES());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function S0(i,e,t){return new qa(i,{minFilter:Ni,generateMipmaps:e,type:ii,colorSpace:jo,depthBuffer:t})}function Ya(i,e,t){return new $n({name:i,uniforms:e,vertexShader:Qe.cube_vert,fragmentShader:t,side:xn,blending:Hs,depthTest:!1,depthWrite:!1})}function SS(){return Ya("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${X0}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function TS(){return Ya("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:q0}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function ES(){return Ya("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${bS}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function T0(){return Ya("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function E0(){return Ya("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function AS(i){let e=new WeakMap,t=new WeakMap,n=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===Kc||f===Jc)if(e.has(d)){let p=e.get(d).texture;return a(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let x=new qa(p.height);return x.fromEquirectangularTexture(i,d),e.set(d,x),d.addEventListener("dispose",c),a(x.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===Kc||f===Jc,x=f===$s||f===jr;if(p||x){let g=t.get(d),m=g!==void 0?g.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==m)return n===null&&(n=new zh(i)),g=p?n.fromEquirectangular(d,g):n.fromCubemap(d,g),g.texture.pmremVersion=d.pmremVersion,t.set(d,g),g.texture;if(g!==void 0)return g.texture;{let y=d.image;return p&&y&&y.height>0||x&&y&&l(y)?(n===null&&(n=new zh(i)),g=p?n.fromEquirectangular(d):n.fromCubemap(d),g.texture.pmremVersion=d.pmremVersion,t.set(d,g),d.addEventListener("dispose",h),g.texture):null}}}return d}function a(d,f){return f===Kc?d.mapping=$s:f===Jc&&(d.mapping=jr),d}function l(d){let f=0,p=6;for(let x=0;x<p;x++)d[x]!==void 0&&f++;return f===p}function c(d){let f=d.target;f.removeEventListener("dispose",c);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function h(d){let f=d.target;f.removeEventListener("dispose",h);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function u(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function RS(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&$o("WebGLRenderer: "+n+" extension not supported."),s}}}function CS(i,e,t,n){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&e.remove(p.index);for(let g in p.attributes)e.remove(p.attributes[g]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let x=r.get(p);x&&(e.remove(x),r.delete(p)),n.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,t.memory.geometries--}function c(p,x){return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),t.memory.geometries++),x}function h(p){let x=p.attributes;for(let g in x)e.update(x[g],i.ARRAY_BUFFER)}function u(p){let x=p.index,g=p.attributes.position,m=0;if(g===void 0)return;let y=x!==null?x.array.length:g.array.length/3-1,S=g.count>=65535?sa:ia,b=new S(Math.ceil(y/3)*6,1),A=b.array;if(x!==null){let v=x.array;m=x.version;for(let T=0,D=0;T<y;T+=3){let P=v[T+0],k=v[T+1],O=v[T+2];A[D++]=P,A[D++]=k,A[D++]=k,A[D++]=O,A[D++]=O,A[D++]=P}}else{m=g.version;for(let v=0,T=0;v<y;v+=3){let D=v+0,P=v+1,k=v+2;A[T++]=D,A[T++]=P,A[T++]=P,A[T++]=k,A[T++]=k,A[T++]=D}}b.version=m;let R=r.get(p);R&&e.remove(R),r.set(p,b)}function d(p){let x=r.get(p);if(x){let g=p.index;g!==null&&x.version<g.version&&u(p)}else u(p);return r.get(p)}function f(){for(let p in s){let x=s[p].deref();x!==void 0&&l(x)}}return{get:c,update:h,getWireframeAttribute:d,dispose:f}}function PS(i,e,t){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,d){i.drawElements(n,d,r,u*o),t.update(d,n,1)}function c(u,d,f){f!==0&&(i.drawElementsInstanced(n,d,r,u*o,f),t.update(d,n,f))}function h(u,d,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,u,0,f);let x=0;for(let g=0;g<f;g++)x+=d[g];t.update(x,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function IS(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:Ve("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function LS(i,e,t){let n=new WeakMap,s=new ft;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=n.get(a);if(d===void 0||d.count!==u){let D=function(){v.dispose(),n.delete(a),a.removeEventListener("dispose",D)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],y=a.morphAttributes.color||[],S=0;f===!0&&(S=1),p===!0&&(S=2),x===!0&&(S=3);let b=a.attributes.position.count*S,A=1;b>e.maxTextureSize&&(A=Math.ceil(b/e.maxTextureSize),b=e.maxTextureSize);let R=new Float32Array(b*A*4*u),v=new ea(R,b,A,u);v.type=Xn,v.needsUpdate=!0;let T=S*4;for(let P=0;P<u;P++){let k=g[P],O=m[P],z=y[P],I=b*A*4*P;for(let H=0;H<k.count;H++){let X=H*T;f===!0&&(s.fromBufferAttribute(k,H),R[I+X+0]=s.x,R[I+X+1]=s.y,R[I+X+2]=s.z,R[I+X+3]=0),p===!0&&(s.fromBufferAttribute(O,H),R[I+X+4]=s.x,R[I+X+5]=s.y,R[I+X+6]=s.z,R[I+X+7]=0),x===!0&&(s.fromBufferAttribute(z,H),R[I+X+8]=s.x,R[I+X+9]=s.y,R[I+X+10]=s.z,R[I+X+11]=z.itemSize===4?s.w:1)}}d={count:u,texture:v,size:new te(b,A)},n.set(a,d),a.addEventListener("dispose",D)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let f=0;for(let x=0;x<c.length;x++)f+=c[x];let p=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",p),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function DS(i,e,t,n,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,d=e.get(c,u);if(r.get(d)!==h&&(e.update(d),r.set(d,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:o,dispose:a}}var NS={[pf]:"LINEAR_TONE_MAPPING",[mf]:"REINHARD_TONE_MAPPING",[gf]:"CINEON_TONE_MAPPING",[xf]:"ACES_FILMIC_TONE_MAPPING",[vf]:"AGX_TONE_MAPPING",[bf]:"NEUTRAL_TONE_MAPPING",[yf]:"CUSTOM_TONE_MAPPING"};function kS(i,e,t,n,s,r){let o=new Dn(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new We;h.setAttribute("position",new Ne([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Ne([0,2,0,0,2,0],2));let u=new Oc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new st(h,u),f=new Ca(-1,1,1,-1,0,1),p=null,x=null,g=!1,m,y=null,S=[],b=!1;this.setSize=function(A,R){o.setSize(A,R),a!==null&&a.setSize(A,R),l!==null&&l.setSize(A,R);for(let v=0;v<S.length;v++){let T=S[v];T.setSize&&T.setSize(A,R)}},this.setEffects=function(A){S=A,b=S.length>0&&S[0].isRenderPass===!0;let R=o.width,v=o.height;S.length>0&&a===null&&(a=new Dn(R,v,{type:ii,depthBuffer:!1,stencilBuffer:!1}),l=new Dn(R,v,{type:ii,depthBuffer:!1,stencilBuffer:!1}));let T=s===!0&&S.some(D=>D.needsDepthTexture===!0);T!==(o.depthTexture!==null)&&(T===!0&&c===null&&(c=new Ii(R,v),r===!0&&(c.format=ki,c.type=Xs)),o.dispose(),o.depthTexture=T?c:null,o.resolveDepthBuffer=T,o.storeMultisampledDepthBuffer=T);for(let D=0;D<S.length;D++){let P=S[D];P.setSize&&P.setSize(R,v),T&&P.needsDepthTexture===!0&&P.setDepthTexture&&P.setDepthTexture(c)}},this.begin=function(A,R){if(g||A.toneMapping===pi&&S.length===0)return!1;if(y=R,R!==null){let v=R.width,T=R.height;(o.width!==v||o.height!==T)&&this.setSize(v,T)}return b===!1&&A.setRenderTarget(o),m=A.toneMapping,A.toneMapping=pi,!0},this.hasRenderPass=function(){return b},this.end=function(A,R){A.toneMapping=m,g=!0;let v=o,T=a;for(let D=0;D<S.length;D++){let P=S[D];P.enabled!==!1&&(P.render(A,T,v,R),P.needsSwap!==!1&&(v=T,T=T===a?l:a))}if(p!==A.outputColorSpace||x!==A.toneMapping){p=A.outputColorSpace,x=A.toneMapping,u.defines={},it.getTransfer(p)===dt&&(u.defines.SRGB_TRANSFER="");let D=NS[x];D&&(u.defines[D]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=v.texture,A.setRenderTarget(y),A.render(d,f),y=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var Y0=new gn,Z0=new Ii(1,1),j0=new ha(1),K0=new ea,J0=new Tc,Q0=new ca,A0=[],R0=[],C0=new Float32Array(16),P0=new Float32Array(9),I0=new Float32Array(4);function to(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=A0[s];if(r===void 0&&(r=new Float32Array(s),A0[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function Ot(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function Ut(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function Gh(i,e){let t=R0[e];t===void 0&&(t=new Int32Array(e),R0[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function OS(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function US(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ot(t,e))return;i.uniform2fv(this.addr,e),Ut(t,e)}}function FS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Ot(t,e))return;i.uniform3fv(this.addr,e),Ut(t,e)}}function BS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ot(t,e))return;i.uniform4fv(this.addr,e),Ut(t,e)}}function zS(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Ot(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),Ut(t,e)}else{if(Ot(t,n))return;I0.set(n),i.uniformMatrix2fv(this.addr,!1,I0),Ut(t,n)}}function VS(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Ot(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),Ut(t,e)}else{if(Ot(t,n))return;P0.set(n),i.uniformMatrix3fv(this.addr,!1,P0),Ut(t,n)}}function GS(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Ot(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),Ut(t,e)}else{if(Ot(t,n))return;C0.set(n),i.uniformMatrix4fv(this.addr,!1,C0),Ut(t,n)}}function HS(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function WS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ot(t,e))return;i.uniform2iv(this.addr,e),Ut(t,e)}}function $S(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Ot(t,e))return;i.uniform3iv(this.addr,e),Ut(t,e)}}function XS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ot(t,e))return;i.uniform4iv(this.addr,e),Ut(t,e)}}function qS(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function YS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ot(t,e))return;i.uniform2uiv(this.addr,e),Ut(t,e)}}function ZS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Ot(t,e))return;i.uniform3uiv(this.addr,e),Ut(t,e)}}function jS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ot(t,e))return;i.uniform4uiv(this.addr,e),Ut(t,e)}}function Hh(i){return i.version===0&&(i.compareFunction=Lf,i.needsUpdate=!0),i}function KS(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Hh(Z0):r=Y0,t.setTexture2D(e||r,s)}function JS(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||J0,s)}function QS(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Hh(j0):r=Q0,t.setTextureCube(e||r,s)}function e1(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||K0,s)}function t1(i){switch(i){case 5126:return OS;case 35664:return US;case 35665:return FS;case 35666:return BS;case 35674:return zS;case 35675:return VS;case 35676:return GS;case 5124:case 35670:return HS;case 35667:case 35671:return WS;case 35668:case 35672:return $S;case 35669:case 35673:return XS;case 5125:return qS;case 36294:return YS;case 36295:return ZS;case 36296:return jS;case 35678:case 36198:case 36298:case 36306:case 35682:return KS;case 35679:case 36299:case 36307:return JS;case 35680:case 36300:case 36308:case 36293:return QS;case 36289:case 36303:case 36311:case 36292:return e1}}function n1(i,e){i.uniform1fv(this.addr,e)}function i1(i,e){let t=to(e,this.size,2);i.uniform2fv(this.addr,t)}function s1(i,e){let t=to(e,this.size,3);i.uniform3fv(this.addr,t)}function r1(i,e){let t=to(e,this.size,4);i.uniform4fv(this.addr,t)}function o1(i,e){let t=to(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function a1(i,e){let t=to(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function l1(i,e){let t=to(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function c1(i,e){i.uniform1iv(this.addr,e)}function h1(i,e){i.uniform2iv(this.addr,e)}function u1(i,e){i.uniform3iv(this.addr,e)}function d1(i,e){i.uniform4iv(this.addr,e)}function f1(i,e){i.uniform1uiv(this.addr,e)}function p1(i,e){i.uniform2uiv(this.addr,e)}function m1(i,e){i.uniform3uiv(this.addr,e)}function g1(i,e){i.uniform4uiv(this.addr,e)}function x1(i,e,t){let n=this.cache,s=e.length,r=Gh(t,s);Ot(n,r)||(i.uniform1iv(this.addr,r),Ut(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=Hh(Z0):o=Y0;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function y1(i,e,t){let n=this.cache,s=e.length,r=Gh(t,s);Ot(n,r)||(i.uniform1iv(this.addr,r),Ut(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||J0,r[o])}function v1(i,e,t){let n=this.cache,s=e.length,r=Gh(t,s);Ot(n,r)||(i.uniform1iv(this.addr,r),Ut(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=Hh(j0):o=Q0;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function b1(i,e,t){let n=this.cache,s=e.length,r=Gh(t,s);Ot(n,r)||(i.uniform1iv(this.addr,r),Ut(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||K0,r[o])}function _1(i){switch(i){case 5126:return n1;case 35664:return i1;case 35665:return s1;case 35666:return r1;case 35674:return o1;case 35675:return a1;case 35676:return l1;case 5124:case 35670:return c1;case 35667:case 35671:return h1;case 35668:case 35672:return u1;case 35669:case 35673:return d1;case 5125:return f1;case 36294:return p1;case 36295:return m1;case 36296:return g1;case 35678:case 36198:case 36298:case 36306:case 35682:return x1;case 35679:case 36299:case 36307:return y1;case 35680:case 36300:case 36308:case 36293:return v1;case 36289:case 36303:case 36311:case 36292:return b1}}var Xf=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=t1(t.type)}},qf=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=_1(t.type)}},Yf=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},Wf=/(\w+)(\])?(\[|\.)?/g;function L0(i,e){i.seq.push(e),i.map[e.id]=e}function w1(i,e,t){let n=i.name,s=n.length;for(Wf.lastIndex=0;;){let r=Wf.exec(n),o=Wf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){L0(t,c===void 0?new Xf(a,i,e):new qf(a,i,e));break}else{let u=t.map[a];u===void 0&&(u=new Yf(a),L0(t,u)),t=u}}}var eo=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);w1(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function D0(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var M1=37297,S1=0;function T1(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var N0=new He;function E1(i){it._getMatrix(N0,it.workingColorSpace,i);let e=`mat3( ${N0.elements.map(t=>t.toFixed(4))} )`;switch(it.getTransfer(i)){case Ko:return[e,"LinearTransferOETF"];case dt:return[e,"sRGBTransferOETF"];default:return De("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function k0(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+T1(i.getShaderSource(e),a)}else return r}function A1(i,e){let t=E1(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var R1={[pf]:"Linear",[mf]:"Reinhard",[gf]:"Cineon",[xf]:"ACESFilmic",[vf]:"AgX",[bf]:"Neutral",[yf]:"Custom"};function C1(i,e){let t=R1[e];return t===void 0?(De("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Bh=new E;function P1(){it.getLuminanceCoefficients(Bh);let i=Bh.x.toFixed(4),e=Bh.y.toFixed(4),t=Bh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function I1(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Xa).join(`
`)}function L1(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function D1(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function Xa(i){return i!==""}function O0(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function U0(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var N1=/^[ \t]*#include +<([\w\d./]+)>/gm;function Zf(i){return i.replace(N1,k1)}function k1(i,e){let t=Qe[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Zf(t)}var O1=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function F0(i){return i.replace(O1,U1)}function U1(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function B0(i){let e=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var F1={[Gs]:"SHADOWMAP_TYPE_PCF",[Yr]:"SHADOWMAP_TYPE_VSM"};function B1(i){return F1[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var z1={[jr]:"ENVMAP_MODE_REFRACTION"};function V1(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":z1[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var G1={[Oa]:"ENVMAP_BLENDING_MULTIPLY",[e0]:"ENVMAP_BLENDING_MIX",[t0]:"ENVMAP_BLENDING_ADD"};function H1(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":G1[i.combine]||"ENVMAP_BLENDING_NONE"}function W1(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=B1(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=V1(t),u=H1(t),d=I1(t),f=L1(r),p=s.createProgram(),x,g,m=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(x=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Xa).join(`
`),x.length>0&&(x+=`
`),g=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Xa).join(`
`),g.length>0&&(g+=`
`)):(x=[B0(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Xa).join(`
`),g=[B0(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+u:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==pi?"#define TONE_MAPPING":"",t.toneMapping!==pi?Qe.tonemapping_pars_fragment:"",t.toneMapping!==pi?C1("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",Qe.colorspace_pars_fragment,A1("linearToOutputTexel",t.outputColorSpace),P1(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Xa).join(`
`)),o=Zf(o),o=O0(o,t),o=U0(o,t),a=Zf(a),a=O0(a,t),a=U0(a,t),o=F0(o),a=F0(a),t.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,x=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,g=["#define varying in",t.glslVersion===Nf?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Nf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let y=m+x+o,S=m+g+a,b=D0(s,s.VERTEX_SHADER,y),A=D0(s,s.FRAGMENT_SHADER,S);s.attachShader(p,b),s.attachShader(p,A),t.index0AttributeName!==void 0?s.bindAttribLocation(p,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function R(P){if(i.debug.checkShaderErrors){let k=s.getProgramInfoLog(p)||"",O=s.getShaderInfoLog(b)||"",z=s.getShaderInfoLog(A)||"",I=k.trim(),H=O.trim(),X=z.trim(),G=!0,ne=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(G=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,p,b,A);else{let $=k0(s,b,"vertex"),J=k0(s,A,"fragment");Ve("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+P.name+`
Material Type: `+P.type+`

Program Info Log: `+I+`
`+$+`
`+J)}else I!==""?De("WebGLProgram: Program Info Log:",I):(H===""||X==="")&&(ne=!1);ne&&(P.diagnostics={runnable:G,programLog:I,vertexShader:{log:H,prefix:x},fragmentShader:{log:X,prefix:g}})}s.deleteShader(b),s.deleteShader(A),v=new eo(s,p),T=D1(s,p)}let v;this.getUniforms=function(){return v===void 0&&R(this),v};let T;this.getAttributes=function(){return T===void 0&&R(this),T};let D=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return D===!1&&(D=s.getProgramParameter(p,M1)),D},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=S1++,this.cacheKey=e,this.usedTimes=1,this.program=p,this.vertexShader=b,this.fragmentShader=A,this}var $1=0,jf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new Kf(e),t.set(e,n)),n}},Kf=class{constructor(e){this.id=$1++,this.code=e,this.usedTimes=0}};function X1(i){return i===hs||i===Ga||i===Ha}function q1(i,e,t,n,s,r){let o=new ta,a=new jf,l=new Set,c=[],h=new Map,u=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(v){return l.add(v),v===0?"uv":`uv${v}`}function p(v,T,D,P,k,O){let z=P.fog,I=k.geometry,H=v.isMeshStandardMaterial||v.isMeshLambertMaterial||v.isMeshPhongMaterial?P.environment:null,X=v.isMeshStandardMaterial||v.isMeshLambertMaterial&&!v.envMap||v.isMeshPhongMaterial&&!v.envMap,G=e.get(v.envMap||H,X),ne=d[v.type],$=n.precision;v.precision!==null&&($=n.getMaxPrecision(v.precision),$!==v.precision&&De("WebGLProgram.getParameters:",v.precision,"not supported, using",$,"instead."));let J=I.morphAttributes.position||I.morphAttributes.normal||I.morphAttributes.color,ee=J!==void 0?J.length:0,we=0;I.morphAttributes.position!==void 0&&(we=1),I.morphAttributes.normal!==void 0&&(we=2),I.morphAttributes.color!==void 0&&(we=3);let ke,Z,xe,Te;if(ne){let ge=yn[ne];ke=ge.vertexShader,Z=ge.fragmentShader}else{ke=v.vertexShader,Z=v.fragmentShader;let ge=a.getVertexShaderStage(v),mt=a.getFragmentShaderStage(v);a.update(v,ge,mt),xe=ge.id,Te=mt.id}let Oe=i.getRenderTarget(),ve=i.state.buffers.depth.getReversed(),Ze=k.isInstancedMesh===!0,Ct=k.isBatchedMesh===!0,Fe=!!v.map,pt=!!v.matcap,xt=!!G,et=xt&&G.isPMREMTexture===!0,qt=!!v.aoMap,Lt=!!v.lightMap,_n=!!v.bumpMap&&v.wireframe===!1,Mt=!!v.normalMap,oi=!!v.displacementMap,Bt=!!v.emissiveMap,Bn=!!v.metalnessMap,zn=!!v.roughnessMap,Vn=v.anisotropy>0,U=v.clearcoat>0,Gn=v.diffuseRoughness>0,_t=v.dispersion>0,wt=v.retroreflectivity>0,me=v.iridescence>0,Dt=v.sheen>0,Ue=v.transmission>0,$e=Vn&&!!v.anisotropyMap,C=U&&!!v.clearcoatMap,_=U&&!!v.clearcoatNormalMap,B=U&&!!v.clearcoatRoughnessMap,se=Gn&&!!v.diffuseRoughnessMap,Q=me&&!!v.iridescenceMap,ae=me&&!!v.iridescenceThicknessMap,de=Dt&&!!v.sheenColorMap,Y=Dt&&!!v.sheenRoughnessMap,j=!!v.specularMap,ce=!!v.specularColorMap,L=!!v.specularIntensityMap,K=Ue&&!!v.transmissionMap,q=Ue&&!!v.thicknessMap,he=!!v.gradientMap,oe=!!v.alphaMap,le=v.alphaTest>0,Pe=!!v.alphaHash,Ke=!!v.extensions,re=pi;v.toneMapped&&(Oe===null||Oe.isXRRenderTarget===!0)&&(re=i.toneMapping);let Ie=et?G.isCompressedCubeTexture?G.image[0].mipmaps:G.mipmaps:null,je={shaderID:ne,shaderType:v.type,shaderName:v.name,vertexShader:ke,fragmentShader:Z,defines:v.defines,customVertexShaderID:xe,customFragmentShaderID:Te,isRawShaderMaterial:v.isRawShaderMaterial===!0,glslVersion:v.glslVersion,precision:$,batching:Ct,batchingColor:Ct&&k._colorsTexture!==null,instancing:Ze,instancingColor:Ze&&k.instanceColor!==null,instancingMorph:Ze&&k.morphTexture!==null,outputColorSpace:Oe===null?i.outputColorSpace:Oe.isXRRenderTarget===!0?Oe.texture.colorSpace:it.workingColorSpace,alphaToCoverage:!!v.alphaToCoverage,map:Fe,matcap:pt,envMap:xt,envMapMode:xt&&G.mapping,envMapPMREM:et,envMapMaxLod:et?Ie.length-1:null,envMapSize:et?Ie[0].width:null,aoMap:qt,lightMap:Lt,bumpMap:_n,normalMap:Mt,displacementMap:oi,emissiveMap:Bt,normalMapObjectSpace:Mt&&v.normalMapType===s0,normalMapTangentSpace:Mt&&v.normalMapType===Jr,packedNormalMap:Mt&&v.normalMapType===Jr&&X1(v.normalMap.format),metalnessMap:Bn,roughnessMap:zn,anisotropy:Vn,anisotropyMap:$e,clearcoat:U,clearcoatMap:C,clearcoatNormalMap:_,clearcoatRoughnessMap:B,diffuseRoughness:Gn,diffuseRoughnessMap:se,dispersion:_t,retroreflection:wt,iridescence:me,iridescenceMap:Q,iridescenceThicknessMap:ae,sheen:Dt,sheenColorMap:de,sheenRoughnessMap:Y,specularMap:j,specularColorMap:ce,specularIntensityMap:L,transmission:Ue,transmissionMap:K,thicknessMap:q,gradientMap:he,opaque:v.transparent===!1&&v.blending===Zr&&v.alphaToCoverage===!1,alphaMap:oe,alphaTest:le,alphaHash:Pe,combine:v.combine,mapUv:Fe&&f(v.map.channel),aoMapUv:qt&&f(v.aoMap.channel),lightMapUv:Lt&&f(v.lightMap.channel),bumpMapUv:_n&&f(v.bumpMap.channel),normalMapUv:Mt&&f(v.normalMap.channel),displacementMapUv:oi&&f(v.displacementMap.channel),emissiveMapUv:Bt&&f(v.emissiveMap.channel),metalnessMapUv:Bn&&f(v.metalnessMap.channel),roughnessMapUv:zn&&f(v.roughnessMap.channel),anisotropyMapUv:$e&&f(v.anisotropyMap.channel),clearcoatMapUv:C&&f(v.clearcoatMap.channel),clearcoatNormalMapUv:_&&f(v.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:B&&f(v.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:se&&f(v.diffuseRoughnessMap.channel),iridescenceMapUv:Q&&f(v.iridescenceMap.channel),iridescenceThicknessMapUv:ae&&f(v.iridescenceThicknessMap.channel),sheenColorMapUv:de&&f(v.sheenColorMap.channel),sheenRoughnessMapUv:Y&&f(v.sheenRoughnessMap.channel),specularMapUv:j&&f(v.specularMap.channel),specularColorMapUv:ce&&f(v.specularColorMap.channel),specularIntensityMapUv:L&&f(v.specularIntensityMap.channel),transmissionMapUv:K&&f(v.transmissionMap.channel),thicknessMapUv:q&&f(v.thicknessMap.channel),alphaMapUv:oe&&f(v.alphaMap.channel),vertexTangents:!!I.attributes.tangent&&(Mt||Vn),vertexNormals:!!I.attributes.normal,vertexColors:v.vertexColors,vertexAlphas:v.vertexColors===!0&&!!I.attributes.color&&I.attributes.color.itemSize===4,pointsUvs:k.isPoints===!0&&!!I.attributes.uv&&(Fe||oe),fog:!!z,useFog:v.fog===!0,fogExp2:!!z&&z.isFogExp2,flatShading:v.wireframe===!1&&(v.flatShading===!0||I.attributes.normal===void 0&&Mt===!1&&(v.isMeshLambertMaterial||v.isMeshPhongMaterial||v.isMeshStandardMaterial||v.isMeshPhysicalMaterial)),sizeAttenuation:v.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:ve,skinning:k.isSkinnedMesh===!0,hasPositionAttribute:I.attributes.position!==void 0,morphTargets:I.morphAttributes.position!==void 0,morphNormals:I.morphAttributes.normal!==void 0,morphColors:I.morphAttributes.color!==void 0,morphTargetsCount:ee,morphTextureStride:we,numSunLights:T.sun.length,numDirLights:T.directional.length,numPointLights:T.point.length,numSpotLights:T.spot.length,numSpotLightMaps:T.spotLightMap.length,numRectAreaLights:T.rectArea.length,numHemiLights:T.hemi.length,numSunLightShadows:T.sunShadowMap.length,numDirLightShadows:T.directionalShadowMap.length,numPointLightShadows:T.pointShadowMap.length,numSpotLightShadows:T.spotShadowMap.length,numSpotLightShadowsWithMaps:T.numSpotLightShadowsWithMaps,numLightProbes:T.numLightProbes,numLightProbeGrids:O.filter(ge=>ge.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:v.dithering,shadowMapEnabled:i.shadowMap.enabled&&D.length>0,shadowMapType:i.shadowMap.type,toneMapping:re,decodeVideoTexture:Fe&&v.map.isVideoTexture===!0&&it.getTransfer(v.map.colorSpace)===dt,decodeVideoTextureEmissive:Bt&&v.emissiveMap.isVideoTexture===!0&&it.getTransfer(v.emissiveMap.colorSpace)===dt,premultipliedAlpha:v.premultipliedAlpha,doubleSided:v.side===hn,flipSided:v.side===xn,useDepthPacking:v.depthPacking>=0,depthPacking:v.depthPacking||0,index0AttributeName:v.index0AttributeName,extensionClipCullDistance:Ke&&v.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Ke&&v.extensions.multiDraw===!0||Ct)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:v.customProgramCacheKey()};return je.vertexUv1s=l.has(1),je.vertexUv2s=l.has(2),je.vertexUv3s=l.has(3),l.clear(),je}function x(v){let T=[];if(v.shaderID?T.push(v.shaderID):(T.push(v.customVertexShaderID),T.push(v.customFragmentShaderID)),v.defines!==void 0)for(let D in v.defines)T.push(D),T.push(v.defines[D]);return v.isRawShaderMaterial===!1&&(g(T,v),m(T,v),T.push(i.outputColorSpace)),T.push(v.customProgramCacheKey),T.join()}function g(v,T){v.push(T.precision),v.push(T.outputColorSpace),v.push(T.envMapMode),v.push(T.envMapPMREM),v.push(T.envMapMaxLod),v.push(T.envMapSize),v.push(T.mapUv),v.push(T.alphaMapUv),v.push(T.lightMapUv),v.push(T.aoMapUv),v.push(T.bumpMapUv),v.push(T.normalMapUv),v.push(T.displacementMapUv),v.push(T.emissiveMapUv),v.push(T.metalnessMapUv),v.push(T.roughnessMapUv),v.push(T.anisotropyMapUv),v.push(T.clearcoatMapUv),v.push(T.clearcoatNormalMapUv),v.push(T.clearcoatRoughnessMapUv),v.push(T.diffuseRoughnessMapUv),v.push(T.iridescenceMapUv),v.push(T.iridescenceThicknessMapUv),v.push(T.sheenColorMapUv),v.push(T.sheenRoughnessMapUv),v.push(T.specularMapUv),v.push(T.specularColorMapUv),v.push(T.specularIntensityMapUv),v.push(T.transmissionMapUv),v.push(T.thicknessMapUv),v.push(T.combine),v.push(T.fogExp2),v.push(T.sizeAttenuation),v.push(T.morphTargetsCount),v.push(T.numSunLights),v.push(T.numDirLights),v.push(T.numPointLights),v.push(T.numSpotLights),v.push(T.numSpotLightMaps),v.push(T.numHemiLights),v.push(T.numRectAreaLights),v.push(T.numSunLightShadows),v.push(T.numDirLightShadows),v.push(T.numPointLightShadows),v.push(T.numSpotLightShadows),v.push(T.numSpotLightShadowsWithMaps),v.push(T.numLightProbes),v.push(T.numLightProbeGrids),v.push(T.shadowMapType),v.push(T.toneMapping),v.push(T.numClippingPlanes),v.push(T.numClipIntersection),v.push(T.depthPacking)}function m(v,T){o.disableAll(),T.instancing&&o.enable(0),T.instancingColor&&o.enable(1),T.instancingMorph&&o.enable(2),T.matcap&&o.enable(3),T.envMap&&o.enable(4),T.normalMapObjectSpace&&o.enable(5),T.normalMapTangentSpace&&o.enable(6),T.clearcoat&&o.enable(7),T.iridescence&&o.enable(8),T.alphaTest&&o.enable(9),T.vertexColors&&o.enable(10),T.vertexAlphas&&o.enable(11),T.vertexUv1s&&o.enable(12),T.vertexUv2s&&o.enable(13),T.vertexUv3s&&o.enable(14),T.vertexTangents&&o.enable(15),T.anisotropy&&o.enable(16),T.alphaHash&&o.enable(17),T.batching&&o.enable(18),T.dispersion&&o.enable(19),T.retroreflection&&o.enable(24),T.diffuseRoughness&&o.enable(25),T.batchingColor&&o.enable(20),T.gradientMap&&o.enable(21),T.packedNormalMap&&o.enable(22),T.vertexNormals&&o.enable(23),v.push(o.mask),o.disableAll(),T.fog&&o.enable(0),T.useFog&&o.enable(1),T.flatShading&&o.enable(2),T.logarithmicDepthBuffer&&o.enable(3),T.reversedDepthBuffer&&o.enable(4),T.skinning&&o.enable(5),T.morphTargets&&o.enable(6),T.morphNormals&&o.enable(7),T.morphColors&&o.enable(8),T.premultipliedAlpha&&o.enable(9),T.shadowMapEnabled&&o.enable(10),T.doubleSided&&o.enable(11),T.flipSided&&o.enable(12),T.useDepthPacking&&o.enable(13),T.dithering&&o.enable(14),T.transmission&&o.enable(15),T.sheen&&o.enable(16),T.opaque&&o.enable(17),T.pointsUvs&&o.enable(18),T.decodeVideoTexture&&o.enable(19),T.decodeVideoTextureEmissive&&o.enable(20),T.alphaToCoverage&&o.enable(21),T.numLightProbeGrids>0&&o.enable(22),T.hasPositionAttribute&&o.enable(23),v.push(o.mask)}function y(v){let T=d[v.type],D;if(T){let P=yn[T];D=Wa.clone(P.uniforms)}else D=v.uniforms;return D}function S(v,T){let D=h.get(T);return D!==void 0?++D.usedTimes:(D=new W1(i,T,v,s),c.push(D),h.set(T,D)),D}function b(v){if(--v.usedTimes===0){let T=c.indexOf(v);c[T]=c[c.length-1],c.pop(),h.delete(v.cacheKey),v.destroy()}}function A(v){a.remove(v)}function R(){a.dispose()}return{getParameters:p,getProgramCacheKey:x,getUniforms:y,acquireProgram:S,releaseProgram:b,releaseShaderCache:A,programs:c,dispose:R}}function Y1(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function Z1(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function z0(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function V0(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,p,x,g,m){let y=i[e];return y===void 0?(y={id:d.id,object:d,geometry:f,material:p,materialVariant:o(d),groupOrder:x,renderOrder:d.renderOrder,z:g,group:m},i[e]=y):(y.id=d.id,y.object=d,y.geometry=f,y.material=p,y.materialVariant=o(d),y.groupOrder=x,y.renderOrder=d.renderOrder,y.z=g,y.group=m),e++,y}function l(d,f,p,x,g,m,y){y.reversedDepth===!0&&(g=-g);let S=a(d,f,p,x,g,m);p.transmission>0?n.push(S):p.transparent===!0?s.push(S):t.push(S)}function c(d,f,p,x,g,m){let y=a(d,f,p,x,g,m);p.transmission>0?n.unshift(y):p.transparent===!0?s.unshift(y):t.unshift(y)}function h(d,f){t.length>1&&t.sort(d||Z1),n.length>1&&n.sort(f||z0),s.length>1&&s.sort(f||z0)}function u(){for(let d=e,f=i.length;d<f;d++){let p=i[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function j1(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new V0,i.set(n,[o])):s>=r.length?(o=new V0,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function K1(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new E,color:new Re};break;case"SpotLight":t={position:new E,direction:new E,color:new Re,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new E,color:new Re,distance:0,decay:0};break;case"HemisphereLight":t={direction:new E,skyColor:new Re,groundColor:new Re};break;case"RectAreaLight":t={color:new Re,position:new E,halfWidth:new E,halfHeight:new E};break}return i[e.id]=t,t}}}function J1(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new te};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new te};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new te,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var Q1=0;function eT(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function tT(i){let e=new K1,t=J1(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new E);let s=new E,r=new Le,o=new Le;function a(c){let h=0,u=0,d=0;for(let O=0;O<9;O++)n.probe[O].set(0,0,0);let f=0,p=0,x=0,g=0,m=0,y=0,S=0,b=0,A=0,R=0,v=0,T=0,D=0,P=0;c.sort(eT);for(let O=0,z=c.length;O<z;O++){let I=c[O],H=I.color,X=I.intensity,G=I.distance,ne=null;if(I.shadow&&I.shadow.map&&(I.shadow.map.texture.format===hs?ne=I.shadow.map.texture:ne=I.shadow.map.depthTexture||I.shadow.map.texture),I.isAmbientLight)h+=H.r*X,u+=H.g*X,d+=H.b*X;else if(I.isLightProbe){for(let $=0;$<9;$++)n.probe[$].addScaledVector(I.sh.coefficients[$],X);P++}else if(I.isSunLight){let $=e.get(I);if($.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let J=I.shadow,ee=t.get(I);ee.shadowIntensity=J.intensity,ee.shadowBias=J.bias,ee.shadowNormalBias=J.normalBias,ee.shadowRadius=J.radius,ee.shadowMapSize.copy(J.mapSize).multiply(J.getFrameExtents()),n.sunShadow[p]=ee,n.sunShadowMap[p]=ne;let we=J.getViewportCount();for(let ke=0;ke<we;ke++)n.sunShadowMatrix[x+ke]=J.getMatrix(ke),n.sunShadowCascade[x+ke]=J._cascadeData[ke];x+=we,p++}n.sun[f]=$,f++}else if(I.isDirectionalLight){let $=e.get(I);if($.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let J=I.shadow,ee=t.get(I);ee.shadowIntensity=J.intensity,ee.shadowBias=J.bias,ee.shadowNormalBias=J.normalBias,ee.shadowRadius=J.radius,ee.shadowMapSize=J.mapSize,n.directionalShadow[g]=ee,n.directionalShadowMap[g]=ne,n.directionalShadowMatrix[g]=I.shadow.matrix,A++}n.directional[g]=$,g++}else if(I.isSpotLight){let $=e.get(I);$.position.setFromMatrixPosition(I.matrixWorld),$.color.copy(H).multiplyScalar(X),$.distance=G,$.coneCos=Math.cos(I.angle),$.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),$.decay=I.decay,n.spot[y]=$;let J=I.shadow;if(I.map&&(n.spotLightMap[T]=I.map,T++,J.updateMatrices(I),I.castShadow&&D++),n.spotLightMatrix[y]=J.matrix,I.castShadow){let ee=t.get(I);ee.shadowIntensity=J.intensity,ee.shadowBias=J.bias,ee.shadowNormalBias=J.normalBias,ee.shadowRadius=J.radius,ee.shadowMapSize=J.mapSize,n.spotShadow[y]=ee,n.spotShadowMap[y]=ne,v++}y++}else if(I.isRectAreaLight){let $=e.get(I);$.color.copy(H).multiplyScalar(X),$.halfWidth.set(I.width*.5,0,0),$.halfHeight.set(0,I.height*.5,0),n.rectArea[S]=$,S++}else if(I.isPointLight){let $=e.get(I);if($.color.copy(I.color).multiplyScalar(I.intensity),$.distance=I.distance,$.decay=I.decay,I.castShadow){let J=I.shadow,ee=t.get(I);ee.shadowIntensity=J.intensity,ee.shadowBias=J.bias,ee.shadowNormalBias=J.normalBias,ee.shadowRadius=J.radius,ee.shadowMapSize=J.mapSize,ee.shadowCameraNear=J.camera.near,ee.shadowCameraFar=J.camera.far,n.pointShadow[m]=ee,n.pointShadowMap[m]=ne,n.pointShadowMatrix[m]=I.shadow.matrix,R++}n.point[m]=$,m++}else if(I.isHemisphereLight){let $=e.get(I);$.skyColor.copy(I.color).multiplyScalar(X),$.groundColor.copy(I.groundColor).multiplyScalar(X),n.hemi[b]=$,b++}}S>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=pe.LTC_FLOAT_1,n.rectAreaLTC2=pe.LTC_FLOAT_2):(n.rectAreaLTC1=pe.LTC_HALF_1,n.rectAreaLTC2=pe.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=d;let k=n.hash;(k.sunLength!==f||k.directionalLength!==g||k.pointLength!==m||k.spotLength!==y||k.rectAreaLength!==S||k.hemiLength!==b||k.numSunShadows!==p||k.numDirectionalShadows!==A||k.numPointShadows!==R||k.numSpotShadows!==v||k.numSpotMaps!==T||k.numLightProbes!==P)&&(n.sun.length=f,n.directional.length=g,n.spot.length=y,n.rectArea.length=S,n.point.length=m,n.hemi.length=b,n.sunShadow.length=p,n.sunShadowMap.length=p,n.sunShadowMatrix.length=x,n.sunShadowCascade.length=x,n.directionalShadow.length=A,n.directionalShadowMap.length=A,n.directionalShadowMatrix.length=A,n.pointShadow.length=R,n.pointShadowMap.length=R,n.pointShadowMatrix.length=R,n.spotShadow.length=v,n.spotShadowMap.length=v,n.spotLightMatrix.length=v+T-D,n.spotLightMap.length=T,n.numSpotLightShadowsWithMaps=D,n.numLightProbes=P,k.sunLength=f,k.directionalLength=g,k.pointLength=m,k.spotLength=y,k.rectAreaLength=S,k.hemiLength=b,k.numSunShadows=p,k.numDirectionalShadows=A,k.numPointShadows=R,k.numSpotShadows=v,k.numSpotMaps=T,k.numLightProbes=P,n.version=Q1++)}function l(c,h){let u=0,d=0,f=0,p=0,x=0,g=0,m=h.matrixWorldInverse;for(let y=0,S=c.length;y<S;y++){let b=c[y];if(b.isSunLight){let A=n.sun[u];A.direction.setFromMatrixPosition(b.matrixWorld),A.direction.transformDirection(m),u++}else if(b.isDirectionalLight){let A=n.directional[d];A.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(m),d++}else if(b.isSpotLight){let A=n.spot[p];A.position.setFromMatrixPosition(b.matrixWorld),A.position.applyMatrix4(m),A.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(m),p++}else if(b.isRectAreaLight){let A=n.rectArea[x];A.position.setFromMatrixPosition(b.matrixWorld),A.position.applyMatrix4(m),o.identity(),r.copy(b.matrixWorld),r.premultiply(m),o.extractRotation(r),A.halfWidth.set(b.width*.5,0,0),A.halfHeight.set(0,b.height*.5,0),A.halfWidth.applyMatrix4(o),A.halfHeight.applyMatrix4(o),x++}else if(b.isPointLight){let A=n.point[f];A.position.setFromMatrixPosition(b.matrixWorld),A.position.applyMatrix4(m),f++}else if(b.isHemisphereLight){let A=n.hemi[g];A.direction.setFromMatrixPosition(b.matrixWorld),A.direction.transformDirection(m),g++}}}return{setup:a,setupView:l,state:n}}function G0(i){let e=new tT(i),t=[],n=[],s=[];function r(u){h.camera=u,t.length=0,n.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):t.push(u)}function a(u){n.push(u)}function l(){e.setup(t),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function c(u){e.setupView(t,u)}let h={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function nT(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new G0(i),e.set(s,[a])):r>=o.length?(a=new G0(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var iT=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,sT=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,rT=[new E(1,0,0),new E(-1,0,0),new E(0,1,0),new E(0,-1,0),new E(0,0,1),new E(0,0,-1)],oT=[new E(0,-1,0),new E(0,-1,0),new E(0,0,1),new E(0,0,-1),new E(0,-1,0),new E(0,-1,0)],H0=new Le,$a=new E,$f=new E;function aT(i,e,t){let n=new es,s=new te,r=new te,o=new ft,a=new Uc,l=new Fc,c={},h=t.maxTextureSize,u={[cs]:xn,[xn]:cs,[hn]:hn},d=new $n({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new te},radius:{value:4}},vertexShader:iT,fragmentShader:sT}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new We;p.setAttribute("position",new ct(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new st(p,d),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Gs;let m=this.type;this.render=function(R,v,T){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||R.length===0)return;this.type===kg&&(De("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Gs);let D=i.getRenderTarget(),P=i.getActiveCubeFace(),k=i.getActiveMipmapLevel(),O=i.state;O.setBlending(Hs),O.buffers.depth.getReversed()===!0?O.buffers.color.setClear(0,0,0,0):O.buffers.color.setClear(1,1,1,1),O.buffers.depth.setTest(!0),O.setScissorTest(!1);let z=m!==this.type;z&&v.traverse(function(I){I.material&&(Array.isArray(I.material)?I.material.forEach(H=>H.needsUpdate=!0):I.material.needsUpdate=!0)});for(let I=0,H=R.length;I<H;I++){let X=R[I],G=X.shadow;if(G===void 0){De("WebGLShadowMap:",X,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;s.copy(G.mapSize);let ne=G.getFrameExtents();s.multiply(ne),r.copy(G.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ne.x),s.x=r.x*ne.x,G.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ne.y),s.y=r.y*ne.y,G.mapSize.y=r.y));let $=i.state.buffers.depth.getReversed();if(G.camera._reversedDepth=$,G.map===null||z===!0){if(G.map!==null&&(G.map.depthTexture!==null&&(G.map.depthTexture.dispose(),G.map.depthTexture=null),G.map.dispose()),this.type===Yr){if(X.isPointLight){De("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}G.map=new Dn(s.x,s.y,{format:hs,type:ii,minFilter:mn,magFilter:mn,generateMipmaps:!1}),G.map.texture.name=X.name+".shadowMap",G.map.depthTexture=new Ii(s.x,s.y,Xn),G.map.depthTexture.name=X.name+".shadowMapDepth",G.map.depthTexture.format=Pi,G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Wt,G.map.depthTexture.magFilter=Wt}else X.isPointLight?(G.map=new qa(s.x),G.map.depthTexture=new ha(s.x,ni)):(G.map=new Dn(s.x,s.y),G.map.depthTexture=new Ii(s.x,s.y,ni)),G.map.depthTexture.name=X.name+".shadowMap",G.map.depthTexture.format=Pi,this.type===Gs?(G.map.depthTexture.compareFunction=$?If:Pf,G.map.depthTexture.minFilter=mn,G.map.depthTexture.magFilter=mn):(G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Wt,G.map.depthTexture.magFilter=Wt);G.camera.updateProjectionMatrix()}G.map.isWebGLCubeRenderTarget!==!0&&(G.map.width!==s.x||G.map.height!==s.y)&&G.map.setSize(s.x,s.y);let J=G.map.isWebGLCubeRenderTarget?6:G.getViewportCount();X.isPointLight!==!0&&G.updateMatrices(X,T);let ee=(G.camera.layers.mask&4294967294)!==0?G.camera.layers:T.layers;for(let we=0;we<J;we++){let ke=G.getCamera(we);if(X.isPointLight){let Z=G.camera,xe=G.matrix,Te=X.distance||Z.far;Te!==Z.far&&(Z.far=Te,Z.updateProjectionMatrix()),$a.setFromMatrixPosition(X.matrixWorld),Z.position.copy($a),$f.copy(Z.position),$f.add(rT[we]),Z.up.copy(oT[we]),Z.lookAt($f),Z.updateMatrixWorld(),xe.makeTranslation(-$a.x,-$a.y,-$a.z),H0.multiplyMatrices(Z.projectionMatrix,Z.matrixWorldInverse),G._frustum.setFromProjectionMatrix(H0,Z.coordinateSystem,Z.reversedDepth)}if(G.map.isWebGLCubeRenderTarget)i.setRenderTarget(G.map,we),i.clear();else{we===0&&(i.setRenderTarget(G.map),i.clear());let Z=G.getViewport(we);o.set(r.x*Z.x,r.y*Z.y,r.x*Z.z,r.y*Z.w),O.viewport(o)}n=G.getFrustum(we),b(v,T,ke,X,ee,this.type)}G.isPointLightShadow!==!0&&this.type===Yr&&y(G,T),G.needsUpdate=!1}m=this.type,g.needsUpdate=!1,i.setRenderTarget(D,P,k)};function y(R,v){let T=e.update(x);d.defines.VSM_SAMPLES!==R.blurSamples&&(d.defines.VSM_SAMPLES=R.blurSamples,f.defines.VSM_SAMPLES=R.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),R.mapPass===null?R.mapPass=new Dn(s.x,s.y,{format:hs,type:ii}):(R.mapPass.width!==R.map.width||R.mapPass.height!==R.map.height)&&R.mapPass.setSize(R.map.width,R.map.height),d.uniforms.shadow_pass.value=R.map.depthTexture,d.uniforms.resolution.value.set(R.map.width,R.map.height),d.uniforms.radius.value=R.radius,i.setRenderTarget(R.mapPass),i.clear(),i.renderBufferDirect(v,null,T,d,x,null),f.uniforms.shadow_pass.value=R.mapPass.texture,f.uniforms.resolution.value.set(R.map.width,R.map.height),f.uniforms.radius.value=R.radius,i.setRenderTarget(R.map),i.clear(),i.renderBufferDirect(v,null,T,f,x,null)}function S(R,v,T,D){let P=null,k=T.isPointLight===!0?R.customDistanceMaterial:R.customDepthMaterial;if(k!==void 0)P=k;else if(P=T.isPointLight===!0?l:a,i.localClippingEnabled&&v.clipShadows===!0&&Array.isArray(v.clippingPlanes)&&v.clippingPlanes.length!==0||v.displacementMap&&v.displacementScale!==0||v.alphaMap&&v.alphaTest>0||v.map&&v.alphaTest>0||v.alphaToCoverage===!0){let O=P.uuid,z=v.uuid,I=c[O];I===void 0&&(I={},c[O]=I);let H=I[z];H===void 0&&(H=P.clone(),I[z]=H,v.addEventListener("dispose",A)),P=H}if(P.visible=v.visible,P.wireframe=v.wireframe,D===Yr?P.side=v.shadowSide!==null?v.shadowSide:v.side:P.side=v.shadowSide!==null?v.shadowSide:u[v.side],P.alphaMap=v.alphaMap,P.alphaTest=v.alphaToCoverage===!0?.5:v.alphaTest,P.map=v.map,P.clipShadows=v.clipShadows,P.clippingPlanes=v.clippingPlanes,P.clipIntersection=v.clipIntersection,P.displacementMap=v.displacementMap,P.displacementScale=v.displacementScale,P.displacementBias=v.displacementBias,P.wireframeLinewidth=v.wireframeLinewidth,P.linewidth=v.linewidth,T.isPointLight===!0&&P.isMeshDistanceMaterial===!0){let O=i.properties.get(P);O.light=T}return P}function b(R,v,T,D,P,k){if(R.visible===!1)return;if(R.layers.test(P)&&(R.isMesh||R.isLine||R.isPoints)&&(R.castShadow||R.receiveShadow&&k===Yr)&&(!R.frustumCulled||R.intersectsFrustum(n))){R.modelViewMatrix.multiplyMatrices(T.matrixWorldInverse,R.matrixWorld);let I=e.update(R),H=R.material;if(Array.isArray(H)){let X=I.groups;for(let G=0,ne=X.length;G<ne;G++){let $=X[G],J=H[$.materialIndex];if(J&&J.visible){let ee=S(R,J,D,k);R.onBeforeShadow(i,R,v,T,I,ee,$),i.renderBufferDirect(T,null,I,ee,R,$),R.onAfterShadow(i,R,v,T,I,ee,$)}}}else if(H.visible){let X=S(R,H,D,k);R.onBeforeShadow(i,R,v,T,I,X,null),i.renderBufferDirect(T,null,I,X,R,null),R.onAfterShadow(i,R,v,T,I,X,null)}}let z=R.children;for(let I=0,H=z.length;I<H;I++)b(z[I],v,T,D,P,k)}function A(R){R.target.removeEventListener("dispose",A);for(let T in c){let D=c[T],P=R.target.uuid;P in D&&(D[P].dispose(),delete D[P])}}}function lT(i,e){function t(){let L=!1,K=new ft,q=null,he=new ft(0,0,0,0);return{setMask:function(oe){q!==oe&&!L&&(i.colorMask(oe,oe,oe,oe),q=oe)},setLocked:function(oe){L=oe},setClear:function(oe,le,Pe,Ke,re){re===!0&&(oe*=Ke,le*=Ke,Pe*=Ke),K.set(oe,le,Pe,Ke),he.equals(K)===!1&&(i.clearColor(oe,le,Pe,Ke),he.copy(K))},reset:function(){L=!1,q=null,he.set(-1,0,0,0)}}}function n(){let L=!1,K=!1,q=null,he=null,oe=null;return{setReversed:function(le){if(K!==le){let Pe=e.get("EXT_clip_control");le?Pe.clipControlEXT(Pe.LOWER_LEFT_EXT,Pe.ZERO_TO_ONE_EXT):Pe.clipControlEXT(Pe.LOWER_LEFT_EXT,Pe.NEGATIVE_ONE_TO_ONE_EXT),K=le;let Ke=oe;oe=null,this.setClear(Ke)}},getReversed:function(){return K},setTest:function(le){le?ve(i.DEPTH_TEST):Ze(i.DEPTH_TEST)},setMask:function(le){q!==le&&!L&&(i.depthMask(le),q=le)},setFunc:function(le){if(K&&(le=p0[le]),he!==le){switch(le){case pc:i.depthFunc(i.NEVER);break;case mc:i.depthFunc(i.ALWAYS);break;case gc:i.depthFunc(i.LESS);break;case Ir:i.depthFunc(i.LEQUAL);break;case xc:i.depthFunc(i.EQUAL);break;case yc:i.depthFunc(i.GEQUAL);break;case vc:i.depthFunc(i.GREATER);break;case bc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}he=le}},setLocked:function(le){L=le},setClear:function(le){oe!==le&&(oe=le,K&&(le=1-le),i.clearDepth(le))},reset:function(){L=!1,q=null,he=null,oe=null,K=!1}}}function s(){let L=!1,K=null,q=null,he=null,oe=null,le=null,Pe=null,Ke=null,re=null;return{setTest:function(Ie){L||(Ie?ve(i.STENCIL_TEST):Ze(i.STENCIL_TEST))},setMask:function(Ie){K!==Ie&&!L&&(i.stencilMask(Ie),K=Ie)},setFunc:function(Ie,je,ge){(q!==Ie||he!==je||oe!==ge)&&(i.stencilFunc(Ie,je,ge),q=Ie,he=je,oe=ge)},setOp:function(Ie,je,ge){(le!==Ie||Pe!==je||Ke!==ge)&&(i.stencilOp(Ie,je,ge),le=Ie,Pe=je,Ke=ge)},setLocked:function(Ie){L=Ie},setClear:function(Ie){re!==Ie&&(i.clearStencil(Ie),re=Ie)},reset:function(){L=!1,K=null,q=null,he=null,oe=null,le=null,Pe=null,Ke=null,re=null}}}let r=new t,o=new n,a=new s,l={},c=new WeakMap,h={},u={},d={},f=new WeakMap,p=[],x=null,g=!1,m=null,y=null,S=null,b=null,A=null,R=null,v=null,T=new Re(0,0,0),D=0,P=!1,k=null,O=null,z=null,I=null,H=null,X=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),G=!1,ne=0,$=i.getParameter(i.VERSION);$.indexOf("WebGL")!==-1?(ne=parseFloat(/^WebGL (\d)/.exec($)[1]),G=ne>=1):$.indexOf("OpenGL ES")!==-1&&(ne=parseFloat(/^OpenGL ES (\d)/.exec($)[1]),G=ne>=2);let J=null,ee={},we=i.getParameter(i.SCISSOR_BOX),ke=i.getParameter(i.VIEWPORT),Z=new ft().fromArray(we),xe=new ft().fromArray(ke);function Te(L,K,q,he){let oe=new Uint8Array(4),le=i.createTexture();i.bindTexture(L,le),i.texParameteri(L,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(L,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Pe=0;Pe<q;Pe++)L===i.TEXTURE_3D||L===i.TEXTURE_2D_ARRAY?i.texImage3D(K,0,i.RGBA,1,1,he,0,i.RGBA,i.UNSIGNED_BYTE,oe):i.texImage2D(K+Pe,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,oe);return le}let Oe={};Oe[i.TEXTURE_2D]=Te(i.TEXTURE_2D,i.TEXTURE_2D,1),Oe[i.TEXTURE_CUBE_MAP]=Te(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Oe[i.TEXTURE_2D_ARRAY]=Te(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Oe[i.TEXTURE_3D]=Te(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ve(i.DEPTH_TEST),o.setFunc(Ir),_n(!1),Mt(lf),ve(i.CULL_FACE),qt(Hs);function ve(L){h[L]!==!0&&(i.enable(L),h[L]=!0)}function Ze(L){h[L]!==!1&&(i.disable(L),h[L]=!1)}function Ct(L,K){return d[L]!==K?(i.bindFramebuffer(L,K),d[L]=K,L===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=K),L===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=K),!0):!1}function Fe(L,K){let q=p,he=!1;if(L){q=f.get(K),q===void 0&&(q=[],f.set(K,q));let oe=L.textures;if(q.length!==oe.length||q[0]!==i.COLOR_ATTACHMENT0){for(let le=0,Pe=oe.length;le<Pe;le++)q[le]=i.COLOR_ATTACHMENT0+le;q.length=oe.length,he=!0}}else q[0]!==i.BACK&&(q[0]=i.BACK,he=!0);he&&i.drawBuffers(q)}function pt(L){return x!==L?(i.useProgram(L),x=L,!0):!1}let xt={[Ws]:i.FUNC_ADD,[Ug]:i.FUNC_SUBTRACT,[Fg]:i.FUNC_REVERSE_SUBTRACT};xt[Bg]=i.MIN,xt[zg]=i.MAX;let et={[Vg]:i.ZERO,[Gg]:i.ONE,[Hg]:i.SRC_COLOR,[df]:i.SRC_ALPHA,[Zg]:i.SRC_ALPHA_SATURATE,[qg]:i.DST_COLOR,[$g]:i.DST_ALPHA,[Wg]:i.ONE_MINUS_SRC_COLOR,[ff]:i.ONE_MINUS_SRC_ALPHA,[Yg]:i.ONE_MINUS_DST_COLOR,[Xg]:i.ONE_MINUS_DST_ALPHA,[jg]:i.CONSTANT_COLOR,[Kg]:i.ONE_MINUS_CONSTANT_COLOR,[Jg]:i.CONSTANT_ALPHA,[Qg]:i.ONE_MINUS_CONSTANT_ALPHA};function qt(L,K,q,he,oe,le,Pe,Ke,re,Ie){if(L===Hs){g===!0&&(Ze(i.BLEND),g=!1);return}if(g===!1&&(ve(i.BLEND),g=!0),L!==Og){if(L!==m||Ie!==P){if((y!==Ws||A!==Ws)&&(i.blendEquation(i.FUNC_ADD),y=Ws,A=Ws),Ie)switch(L){case Zr:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case cf:i.blendFunc(i.ONE,i.ONE);break;case hf:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case uf:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:Ve("WebGLState: Invalid blending: ",L);break}else switch(L){case Zr:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case cf:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case hf:Ve("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case uf:Ve("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Ve("WebGLState: Invalid blending: ",L);break}S=null,b=null,R=null,v=null,T.set(0,0,0),D=0,m=L,P=Ie}return}oe=oe||K,le=le||q,Pe=Pe||he,(K!==y||oe!==A)&&(i.blendEquationSeparate(xt[K],xt[oe]),y=K,A=oe),(q!==S||he!==b||le!==R||Pe!==v)&&(i.blendFuncSeparate(et[q],et[he],et[le],et[Pe]),S=q,b=he,R=le,v=Pe),(Ke.equals(T)===!1||re!==D)&&(i.blendColor(Ke.r,Ke.g,Ke.b,re),T.copy(Ke),D=re),m=L,P=!1}function Lt(L,K){L.side===hn?Ze(i.CULL_FACE):ve(i.CULL_FACE);let q=L.side===xn;K&&(q=!q),_n(q),L.blending===Zr&&L.transparent===!1?qt(Hs):qt(L.blending,L.blendEquation,L.blendSrc,L.blendDst,L.blendEquationAlpha,L.blendSrcAlpha,L.blendDstAlpha,L.blendColor,L.blendAlpha,L.premultipliedAlpha),o.setFunc(L.depthFunc),o.setTest(L.depthTest),o.setMask(L.depthWrite),r.setMask(L.colorWrite);let he=L.stencilWrite;a.setTest(he),he&&(a.setMask(L.stencilWriteMask),a.setFunc(L.stencilFunc,L.stencilRef,L.stencilFuncMask),a.setOp(L.stencilFail,L.stencilZFail,L.stencilZPass)),Bt(L.polygonOffset,L.polygonOffsetFactor,L.polygonOffsetUnits),L.alphaToCoverage===!0?ve(i.SAMPLE_ALPHA_TO_COVERAGE):Ze(i.SAMPLE_ALPHA_TO_COVERAGE)}function _n(L){k!==L&&(L?i.frontFace(i.CW):i.frontFace(i.CCW),k=L)}function Mt(L){L!==Dg?(ve(i.CULL_FACE),L!==O&&(L===lf?i.cullFace(i.BACK):L===Ng?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Ze(i.CULL_FACE),O=L}function oi(L){L!==z&&(G&&i.lineWidth(L),z=L)}function Bt(L,K,q){L?(ve(i.POLYGON_OFFSET_FILL),(I!==K||H!==q)&&(I=K,H=q,o.getReversed()&&(K=-K,q=-q),i.polygonOffset(K,q))):Ze(i.POLYGON_OFFSET_FILL)}function Bn(L){L?ve(i.SCISSOR_TEST):Ze(i.SCISSOR_TEST)}function zn(L){L===void 0&&(L=i.TEXTURE0+X-1),J!==L&&(i.activeTexture(L),J=L)}function Vn(L,K,q){q===void 0&&(J===null?q=i.TEXTURE0+X-1:q=J);let he=ee[q];he===void 0&&(he={type:void 0,texture:void 0},ee[q]=he),(he.type!==L||he.texture!==K)&&(J!==q&&(i.activeTexture(q),J=q),i.bindTexture(L,K||Oe[L]),he.type=L,he.texture=K)}function U(){let L=ee[J];L!==void 0&&L.type!==void 0&&(i.bindTexture(L.type,null),L.type=void 0,L.texture=void 0)}function Gn(){try{i.compressedTexImage2D(...arguments)}catch(L){Ve("WebGLState:",L)}}function _t(){try{i.compressedTexImage3D(...arguments)}catch(L){Ve("WebGLState:",L)}}function wt(){try{i.texSubImage2D(...arguments)}catch(L){Ve("WebGLState:",L)}}function me(){try{i.texSubImage3D(...arguments)}catch(L){Ve("WebGLState:",L)}}function Dt(){try{i.compressedTexSubImage2D(...arguments)}catch(L){Ve("WebGLState:",L)}}function Ue(){try{i.compressedTexSubImage3D(...arguments)}catch(L){Ve("WebGLState:",L)}}function $e(){try{i.texStorage2D(...arguments)}catch(L){Ve("WebGLState:",L)}}function C(){try{i.texStorage3D(...arguments)}catch(L){Ve("WebGLState:",L)}}function _(){try{i.texImage2D(...arguments)}catch(L){Ve("WebGLState:",L)}}function B(){try{i.texImage3D(...arguments)}catch(L){Ve("WebGLState:",L)}}function se(L){return u[L]!==void 0?u[L]:i.getParameter(L)}function Q(L,K){u[L]!==K&&(i.pixelStorei(L,K),u[L]=K)}function ae(L){Z.equals(L)===!1&&(i.scissor(L.x,L.y,L.z,L.w),Z.copy(L))}function de(L){xe.equals(L)===!1&&(i.viewport(L.x,L.y,L.z,L.w),xe.copy(L))}function Y(L,K){let q=c.get(K);q===void 0&&(q=new WeakMap,c.set(K,q));let he=q.get(L);he===void 0&&(he=i.getUniformBlockIndex(K,L.name),i.uniformBlockBinding(K,he,he),q.set(L,he))}function j(L,K,q){let oe=c.get(K).get(L);l[oe]!==q&&(i.bindBufferBase(i.UNIFORM_BUFFER,oe,q),l[oe]=q)}function ce(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},J=null,ee={},d={},l={},f=new WeakMap,p=[],x=null,g=!1,m=null,y=null,S=null,b=null,A=null,R=null,v=null,T=new Re(0,0,0),D=0,P=!1,k=null,O=null,z=null,I=null,H=null,Z.set(0,0,i.canvas.width,i.canvas.height),xe.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:ve,disable:Ze,bindFramebuffer:Ct,drawBuffers:Fe,useProgram:pt,setBlending:qt,setMaterial:Lt,setFlipSided:_n,setCullFace:Mt,setLineWidth:oi,setPolygonOffset:Bt,setScissorTest:Bn,activeTexture:zn,bindTexture:Vn,unbindTexture:U,compressedTexImage2D:Gn,compressedTexImage3D:_t,texImage2D:_,texImage3D:B,pixelStorei:Q,getParameter:se,updateUBOMapping:Y,uniformBlockBinding:j,texStorage2D:$e,texStorage3D:C,texSubImage2D:wt,texSubImage3D:me,compressedTexSubImage2D:Dt,compressedTexSubImage3D:Ue,scissor:ae,viewport:de,reset:ce}}function cT(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new te,h=new WeakMap,u=new Set,d,f=new WeakMap,p=new Set,x=new FinalizationRegistry(C=>p.delete(C)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(C,_){return g?new OffscreenCanvas(C,_):Jo("canvas")}function y(C,_,B){let se=1,Q=$e(C);if((Q.width>B||Q.height>B)&&(se=B/Math.max(Q.width,Q.height)),se<1)if(typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&C instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&C instanceof ImageBitmap||typeof VideoFrame<"u"&&C instanceof VideoFrame){let ae=Math.floor(se*Q.width),de=Math.floor(se*Q.height);d===void 0&&(d=m(ae,de));let Y=_?m(ae,de):d;return Y.width=ae,Y.height=de,Y.getContext("2d").drawImage(C,0,0,ae,de),De("WebGLRenderer: Texture has been resized from ("+Q.width+"x"+Q.height+") to ("+ae+"x"+de+")."),Y}else return"data"in C&&De("WebGLRenderer: Image in DataTexture is too big ("+Q.width+"x"+Q.height+")."),C;return C}function S(C){return C.generateMipmaps}function b(C){i.generateMipmap(C)}function A(C){return C.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:C.isWebGL3DRenderTarget?i.TEXTURE_3D:C.isWebGLArrayRenderTarget||C.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function R(C,_,B,se,Q,ae=!1){if(C!==null){if(i[C]!==void 0)return i[C];De("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+C+"'")}let de;se&&(de=e.get("EXT_texture_norm16"),de||De("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let Y=_;if(_===i.RED&&(B===i.FLOAT&&(Y=i.R32F),B===i.HALF_FLOAT&&(Y=i.R16F),B===i.UNSIGNED_BYTE&&(Y=i.R8),B===i.UNSIGNED_SHORT&&de&&(Y=de.R16_EXT),B===i.SHORT&&de&&(Y=de.R16_SNORM_EXT)),_===i.RED_INTEGER&&(B===i.UNSIGNED_BYTE&&(Y=i.R8UI),B===i.UNSIGNED_SHORT&&(Y=i.R16UI),B===i.UNSIGNED_INT&&(Y=i.R32UI),B===i.BYTE&&(Y=i.R8I),B===i.SHORT&&(Y=i.R16I),B===i.INT&&(Y=i.R32I)),_===i.RG&&(B===i.FLOAT&&(Y=i.RG32F),B===i.HALF_FLOAT&&(Y=i.RG16F),B===i.UNSIGNED_BYTE&&(Y=i.RG8),B===i.UNSIGNED_SHORT&&de&&(Y=de.RG16_EXT),B===i.SHORT&&de&&(Y=de.RG16_SNORM_EXT)),_===i.RG_INTEGER&&(B===i.UNSIGNED_BYTE&&(Y=i.RG8UI),B===i.UNSIGNED_SHORT&&(Y=i.RG16UI),B===i.UNSIGNED_INT&&(Y=i.RG32UI),B===i.BYTE&&(Y=i.RG8I),B===i.SHORT&&(Y=i.RG16I),B===i.INT&&(Y=i.RG32I)),_===i.RGB_INTEGER&&(B===i.UNSIGNED_BYTE&&(Y=i.RGB8UI),B===i.UNSIGNED_SHORT&&(Y=i.RGB16UI),B===i.UNSIGNED_INT&&(Y=i.RGB32UI),B===i.BYTE&&(Y=i.RGB8I),B===i.SHORT&&(Y=i.RGB16I),B===i.INT&&(Y=i.RGB32I)),_===i.RGBA_INTEGER&&(B===i.UNSIGNED_BYTE&&(Y=i.RGBA8UI),B===i.UNSIGNED_SHORT&&(Y=i.RGBA16UI),B===i.UNSIGNED_INT&&(Y=i.RGBA32UI),B===i.BYTE&&(Y=i.RGBA8I),B===i.SHORT&&(Y=i.RGBA16I),B===i.INT&&(Y=i.RGBA32I)),_===i.RGB&&(B===i.UNSIGNED_SHORT&&de&&(Y=de.RGB16_EXT),B===i.SHORT&&de&&(Y=de.RGB16_SNORM_EXT),B===i.UNSIGNED_INT_5_9_9_9_REV&&(Y=i.RGB9_E5),B===i.UNSIGNED_INT_10F_11F_11F_REV&&(Y=i.R11F_G11F_B10F)),_===i.RGBA){let j=ae?Ko:it.getTransfer(Q);B===i.FLOAT&&(Y=i.RGBA32F),B===i.HALF_FLOAT&&(Y=i.RGBA16F),B===i.UNSIGNED_BYTE&&(Y=j===dt?i.SRGB8_ALPHA8:i.RGBA8),B===i.UNSIGNED_SHORT&&de&&(Y=de.RGBA16_EXT),B===i.SHORT&&de&&(Y=de.RGBA16_SNORM_EXT),B===i.UNSIGNED_SHORT_4_4_4_4&&(Y=i.RGBA4),B===i.UNSIGNED_SHORT_5_5_5_1&&(Y=i.RGB5_A1)}return(Y===i.R16F||Y===i.R32F||Y===i.RG16F||Y===i.RG32F||Y===i.RGBA16F||Y===i.RGBA32F)&&e.get("EXT_color_buffer_float"),Y}function v(C,_){let B;return C?_===null||_===ni||_===Xs?B=i.DEPTH24_STENCIL8:_===Xn?B=i.DEPTH32F_STENCIL8:_===Kr&&(B=i.DEPTH24_STENCIL8,De("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):_===null||_===ni||_===Xs?B=i.DEPTH_COMPONENT24:_===Xn?B=i.DEPTH_COMPONENT32F:_===Kr&&(B=i.DEPTH_COMPONENT16),B}function T(C,_){return S(C)===!0||C.isFramebufferTexture&&C.minFilter!==Wt&&C.minFilter!==mn?Math.log2(Math.max(_.width,_.height))+1:C.mipmaps.length>0?C.mipmaps.length:C.isCompressedTexture&&Array.isArray(C.image)?_.mipmaps.length:1}function D(C){let _=new WeakRef(C);n.get(C).__ref=_,p.add(_),x.register(C,_,_)}function P(C){let _=n.get(C).__ref;_!==void 0&&(p.delete(_),x.unregister(_))}function k(C){z(C.target)}function O(C){I(C.target)}function z(C){C.removeEventListener("dispose",k),P(C),X(C),C.isVideoTexture&&h.delete(C),C.isHTMLTexture&&u.delete(C)}function I(C){C.removeEventListener("dispose",O),P(C),ne(C)}function H(){for(let C of p){let _=C.deref();_!==void 0&&(_.isRenderTarget===!0?I(_):z(_))}p.clear(),u.clear()}function X(C){let _=n.get(C);if(_.__webglInit===void 0)return;let B=C.source,se=f.get(B);if(se){let Q=se[_.__cacheKey];Q.usedTimes--,Q.usedTimes===0&&G(C),Object.keys(se).length===0&&f.delete(B)}n.remove(C)}function G(C){let _=n.get(C);i.deleteTexture(_.__webglTexture);let B=C.source,se=f.get(B);delete se[_.__cacheKey],o.memory.textures--}function ne(C){let _=n.get(C);_.__depthDisposeCallback&&_.__depthDisposeCallback();let B=C.depthTexture;if(B&&B.renderTarget===C&&z(B),C.isWebGLCubeRenderTarget)for(let Q=0;Q<6;Q++){if(Array.isArray(_.__webglFramebuffer[Q]))for(let ae=0;ae<_.__webglFramebuffer[Q].length;ae++)i.deleteFramebuffer(_.__webglFramebuffer[Q][ae]);else i.deleteFramebuffer(_.__webglFramebuffer[Q]);_.__webglDepthbuffer&&i.deleteRenderbuffer(_.__webglDepthbuffer[Q])}else{if(Array.isArray(_.__webglFramebuffer))for(let Q=0;Q<_.__webglFramebuffer.length;Q++)i.deleteFramebuffer(_.__webglFramebuffer[Q]);else i.deleteFramebuffer(_.__webglFramebuffer);if(_.__webglDepthbuffer&&i.deleteRenderbuffer(_.__webglDepthbuffer),_.__webglMultisampledFramebuffer&&i.deleteFramebuffer(_.__webglMultisampledFramebuffer),_.__webglColorRenderbuffer)for(let Q=0;Q<_.__webglColorRenderbuffer.length;Q++)_.__webglColorRenderbuffer[Q]&&i.deleteRenderbuffer(_.__webglColorRenderbuffer[Q]);_.__webglDepthRenderbuffer&&i.deleteRenderbuffer(_.__webglDepthRenderbuffer)}let se=C.textures;for(let Q=0,ae=se.length;Q<ae;Q++){let de=n.get(se[Q]);de.__webglTexture&&(i.deleteTexture(de.__webglTexture),o.memory.textures--),n.remove(se[Q])}n.remove(C)}let $=0;function J(){$=0}function ee(){return $}function we(C){$=C}function ke(){let C=$;return C>=s.maxTextures&&De("WebGLTextures: Trying to use "+(C+1)+" texture units while this GPU supports only "+s.maxTextures),$+=1,C}function Z(C){let _=[];return _.push(C.wrapS),_.push(C.wrapT),_.push(C.wrapR||0),_.push(C.magFilter),_.push(C.minFilter),_.push(C.anisotropy),_.push(C.internalFormat),_.push(C.format),_.push(C.type),_.push(C.generateMipmaps),_.push(C.mipmapsAutoUpdate),_.push(C.premultiplyAlpha),_.push(C.flipY),_.push(C.unpackAlignment),_.push(C.colorSpace),_.join()}function xe(C,_){let B=n.get(C);if(C.isVideoTexture&&Dt(C),C.isRenderTargetTexture===!1&&C.isExternalTexture!==!0&&C.version>0&&B.__version!==C.version){let se=C.image;if(se===null)De("WebGLRenderer: Texture marked for update but no image data found.");else if(se.complete===!1)De("WebGLRenderer: Texture marked for update but image is incomplete");else{Lt(B,C,_);return}}else C.isExternalTexture&&(B.__webglTexture=C.sourceTexture?C.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,B.__webglTexture,i.TEXTURE0+_)}function Te(C,_){let B=n.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&B.__version!==C.version){Lt(B,C,_);return}else C.isExternalTexture&&(B.__webglTexture=C.sourceTexture?C.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,B.__webglTexture,i.TEXTURE0+_)}function Oe(C,_){let B=n.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&B.__version!==C.version){Lt(B,C,_);return}t.bindTexture(i.TEXTURE_3D,B.__webglTexture,i.TEXTURE0+_)}function ve(C,_){let B=n.get(C);if(C.version>0&&B.__version!==C.version){_n(B,C,_);return}t.bindTexture(i.TEXTURE_CUBE_MAP,B.__webglTexture,i.TEXTURE0+_)}let Ze={[Lr]:i.REPEAT,[di]:i.CLAMP_TO_EDGE,[_c]:i.MIRRORED_REPEAT},Ct={[Wt]:i.NEAREST,[n0]:i.NEAREST_MIPMAP_NEAREST,[Ua]:i.NEAREST_MIPMAP_LINEAR,[mn]:i.LINEAR,[Qc]:i.LINEAR_MIPMAP_NEAREST,[Ni]:i.LINEAR_MIPMAP_LINEAR},Fe={[o0]:i.NEVER,[Lf]:i.ALWAYS,[a0]:i.LESS,[Pf]:i.LEQUAL,[l0]:i.EQUAL,[If]:i.GEQUAL,[c0]:i.GREATER,[h0]:i.NOTEQUAL};function pt(C,_){if(_.type===Xn&&e.has("OES_texture_float_linear")===!1&&(_.magFilter===mn||_.magFilter===Qc||_.magFilter===Ua||_.magFilter===Ni||_.minFilter===mn||_.minFilter===Qc||_.minFilter===Ua||_.minFilter===Ni)&&De("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(C,i.TEXTURE_WRAP_S,Ze[_.wrapS]),i.texParameteri(C,i.TEXTURE_WRAP_T,Ze[_.wrapT]),(C===i.TEXTURE_3D||C===i.TEXTURE_2D_ARRAY)&&i.texParameteri(C,i.TEXTURE_WRAP_R,Ze[_.wrapR]),i.texParameteri(C,i.TEXTURE_MAG_FILTER,Ct[_.magFilter]),i.texParameteri(C,i.TEXTURE_MIN_FILTER,Ct[_.minFilter]),_.compareFunction&&(i.texParameteri(C,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(C,i.TEXTURE_COMPARE_FUNC,Fe[_.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(_.magFilter===Wt||_.minFilter!==Ua&&_.minFilter!==Ni||_.type===Xn&&e.has("OES_texture_float_linear")===!1)return;if(_.anisotropy>1||n.get(_).__currentAnisotropy){let B=e.get("EXT_texture_filter_anisotropic");i.texParameterf(C,B.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(_.anisotropy,s.getMaxAnisotropy())),n.get(_).__currentAnisotropy=_.anisotropy}}}function xt(C,_){let B=!1;C.__webglInit===void 0&&(C.__webglInit=!0,_.addEventListener("dispose",k),D(_));let se=_.source,Q=f.get(se);Q===void 0&&(Q={},f.set(se,Q));let ae=Z(_);if(ae!==C.__cacheKey){Q[ae]===void 0&&(Q[ae]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,B=!0),Q[ae].usedTimes++;let de=Q[C.__cacheKey];de!==void 0&&(Q[C.__cacheKey].usedTimes--,de.usedTimes===0&&G(_)),C.__cacheKey=ae,C.__webglTexture=Q[ae].texture}return B}function et(C,_,B){return Math.floor(Math.floor(C/B)/_)}function qt(C,_,B,se){let ae=C.updateRanges;if(ae.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,_.width,_.height,B,se,_.data);else{ae.sort((L,K)=>L.start-K.start);let de=0;for(let L=1;L<ae.length;L++){let K=ae[de],q=ae[L],he=K.start+K.count,oe=et(q.start,_.width,4),le=et(K.start,_.width,4);q.start<=he+1&&oe===le&&et(q.start+q.count-1,_.width,4)===oe?K.count=Math.max(K.count,q.start+q.count-K.start):(++de,ae[de]=q)}ae.length=de+1;let Y=t.getParameter(i.UNPACK_ROW_LENGTH),j=t.getParameter(i.UNPACK_SKIP_PIXELS),ce=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,_.width);for(let L=0,K=ae.length;L<K;L++){let q=ae[L],he=Math.floor(q.start/4),oe=Math.ceil(q.count/4),le=he%_.width,Pe=Math.floor(he/_.width),Ke=oe,re=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,le),t.pixelStorei(i.UNPACK_SKIP_ROWS,Pe),t.texSubImage2D(i.TEXTURE_2D,0,le,Pe,Ke,re,B,se,_.data)}C.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,Y),t.pixelStorei(i.UNPACK_SKIP_PIXELS,j),t.pixelStorei(i.UNPACK_SKIP_ROWS,ce)}}function Lt(C,_,B){let se=i.TEXTURE_2D;(_.isDataArrayTexture||_.isCompressedArrayTexture)&&(se=i.TEXTURE_2D_ARRAY),_.isData3DTexture&&(se=i.TEXTURE_3D);let Q=xt(C,_),ae=_.source;t.bindTexture(se,C.__webglTexture,i.TEXTURE0+B);let de=n.get(ae);if(ae.version!==de.__version||Q===!0){if(t.activeTexture(i.TEXTURE0+B),(typeof ImageBitmap<"u"&&_.image instanceof ImageBitmap)===!1){let re=it.getPrimaries(it.workingColorSpace),Ie=_.colorSpace===Oi?null:it.getPrimaries(_.colorSpace),je=_.colorSpace===Oi||re===Ie?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,_.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,_.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,je)}t.pixelStorei(i.UNPACK_ALIGNMENT,_.unpackAlignment);let j=y(_.image,!1,s.maxTextureSize);j=Ue(_,j);let ce=r.convert(_.format,_.colorSpace),L=r.convert(_.type),K=R(_.internalFormat,ce,L,_.normalized,_.colorSpace,_.isVideoTexture);pt(se,_);let q,he=_.mipmaps,oe=_.isVideoTexture!==!0,le=de.__version===void 0||Q===!0,Pe=ae.dataReady,Ke=T(_,j);if(_.isDepthTexture)K=v(_.format===ki,_.type),le&&(oe?t.texStorage2D(i.TEXTURE_2D,1,K,j.width,j.height):t.texImage2D(i.TEXTURE_2D,0,K,j.width,j.height,0,ce,L,null));else if(_.isDataTexture)if(he.length>0){oe&&le&&t.texStorage2D(i.TEXTURE_2D,Ke,K,he[0].width,he[0].height);for(let re=0,Ie=he.length;re<Ie;re++)q=he[re],oe?Pe&&t.texSubImage2D(i.TEXTURE_2D,re,0,0,q.width,q.height,ce,L,q.data):t.texImage2D(i.TEXTURE_2D,re,K,q.width,q.height,0,ce,L,q.data);_.generateMipmaps=!1}else oe?(le&&t.texStorage2D(i.TEXTURE_2D,Ke,K,j.width,j.height),Pe&&qt(_,j,ce,L)):t.texImage2D(i.TEXTURE_2D,0,K,j.width,j.height,0,ce,L,j.data);else if(_.isCompressedTexture)if(_.isCompressedArrayTexture){oe&&le&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Ke,K,he[0].width,he[0].height,j.depth);for(let re=0,Ie=he.length;re<Ie;re++)if(q=he[re],_.format!==si)if(ce!==null)if(oe){if(Pe)if(_.layerUpdates.size>0){let je=Hf(q.width,q.height,_.format,_.type);for(let ge of _.layerUpdates){let mt=q.data.subarray(ge*je/q.data.BYTES_PER_ELEMENT,(ge+1)*je/q.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,re,0,0,ge,q.width,q.height,1,ce,mt)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,re,0,0,0,q.width,q.height,j.depth,ce,q.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,re,K,q.width,q.height,j.depth,0,q.data,0,0);else De("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else oe?Pe&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,re,0,0,0,q.width,q.height,j.depth,ce,L,q.data):t.texImage3D(i.TEXTURE_2D_ARRAY,re,K,q.width,q.height,j.depth,0,ce,L,q.data);_.layerUpdates.size>0&&_.clearLayerUpdates()}else{oe&&le&&t.texStorage2D(i.TEXTURE_2D,Ke,K,he[0].width,he[0].height);for(let re=0,Ie=he.length;re<Ie;re++)q=he[re],_.format!==si?ce!==null?oe?Pe&&t.compressedTexSubImage2D(i.TEXTURE_2D,re,0,0,q.width,q.height,ce,q.data):t.compressedTexImage2D(i.TEXTURE_2D,re,K,q.width,q.height,0,q.data):De("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):oe?Pe&&t.texSubImage2D(i.TEXTURE_2D,re,0,0,q.width,q.height,ce,L,q.data):t.texImage2D(i.TEXTURE_2D,re,K,q.width,q.height,0,ce,L,q.data)}else if(_.isDataArrayTexture)if(oe){if(le&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Ke,K,j.width,j.height,j.depth),Pe)if(_.layerUpdates.size>0){let re=Hf(j.width,j.height,_.format,_.type);for(let Ie of _.layerUpdates){let je=j.data.subarray(Ie*re/j.data.BYTES_PER_ELEMENT,(Ie+1)*re/j.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Ie,j.width,j.height,1,ce,L,je)}_.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,j.width,j.height,j.depth,ce,L,j.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,K,j.width,j.height,j.depth,0,ce,L,j.data);else if(_.isData3DTexture)oe?(le&&t.texStorage3D(i.TEXTURE_3D,Ke,K,j.width,j.height,j.depth),Pe&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,j.width,j.height,j.depth,ce,L,j.data)):t.texImage3D(i.TEXTURE_3D,0,K,j.width,j.height,j.depth,0,ce,L,j.data);else if(_.isFramebufferTexture){if(le)if(oe)t.texStorage2D(i.TEXTURE_2D,Ke,K,j.width,j.height);else{let re=j.width,Ie=j.height;for(let je=0;je<Ke;je++)t.texImage2D(i.TEXTURE_2D,je,K,re,Ie,0,ce,L,null),re>>=1,Ie>>=1}}else if(_.isHTMLTexture){if("texElementImage2D"in i){let re=i.canvas;if(re.hasAttribute("layoutsubtree")||re.setAttribute("layoutsubtree","true"),j.parentNode!==re){re.appendChild(j),u.add(_),re.onpaint=Ie=>{let je=Ie.changedElements;for(let ge of u)je.includes(ge.image)&&(ge.needsUpdate=!0)},re.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,j);else{let je=i.RGBA,ge=i.RGBA,mt=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,je,ge,mt,j)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(he.length>0){if(oe&&le){let re=$e(he[0]);t.texStorage2D(i.TEXTURE_2D,Ke,K,re.width,re.height)}for(let re=0,Ie=he.length;re<Ie;re++)q=he[re],oe?Pe&&t.texSubImage2D(i.TEXTURE_2D,re,0,0,ce,L,q):t.texImage2D(i.TEXTURE_2D,re,K,ce,L,q);_.generateMipmaps=!1}else if(oe){if(le){let re=$e(j);t.texStorage2D(i.TEXTURE_2D,Ke,K,re.width,re.height)}Pe&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,ce,L,j)}else t.texImage2D(i.TEXTURE_2D,0,K,ce,L,j);S(_)&&_.mipmapsAutoUpdate===!0&&b(se),de.__version=ae.version,_.onUpdate&&_.onUpdate(_)}C.__version=_.version}function _n(C,_,B){if(_.image.length!==6)return;let se=xt(C,_),Q=_.source;t.bindTexture(i.TEXTURE_CUBE_MAP,C.__webglTexture,i.TEXTURE0+B);let ae=n.get(Q);if(Q.version!==ae.__version||se===!0){t.activeTexture(i.TEXTURE0+B);let de=it.getPrimaries(it.workingColorSpace),Y=_.colorSpace===Oi?null:it.getPrimaries(_.colorSpace),j=_.colorSpace===Oi||de===Y?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,_.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,_.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,_.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,j);let ce=_.isCompressedTexture||_.image[0].isCompressedTexture,L=_.image[0]&&_.image[0].isDataTexture,K=[];for(let ge=0;ge<6;ge++)!ce&&!L?K[ge]=y(_.image[ge],!0,s.maxCubemapSize):K[ge]=L?_.image[ge].image:_.image[ge],K[ge]=Ue(_,K[ge]);let q=K[0],he=r.convert(_.format,_.colorSpace),oe=r.convert(_.type),le=R(_.internalFormat,he,oe,_.normalized,_.colorSpace),Pe=_.isVideoTexture!==!0,Ke=ae.__version===void 0||se===!0,re=Q.dataReady,Ie=T(_,q);pt(i.TEXTURE_CUBE_MAP,_);let je;if(_.isDepthTexture){if(le=v(_.format===ki,_.type),Ke)if(Pe)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,le,q.width,q.height);else for(let ge=0;ge<6;ge++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,le,q.width,q.height,0,he,oe,null)}else if(ce){Pe&&Ke&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Ie,le,q.width,q.height);for(let ge=0;ge<6;ge++){je=K[ge].mipmaps;for(let mt=0;mt<je.length;mt++){let zt=je[mt];_.format!==si?he!==null?Pe?re&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,mt,0,0,zt.width,zt.height,he,zt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,mt,le,zt.width,zt.height,0,zt.data):De("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Pe?re&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,mt,0,0,zt.width,zt.height,he,oe,zt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,mt,le,zt.width,zt.height,0,he,oe,zt.data)}}}else{if(je=_.mipmaps,Pe&&Ke){je.length>0&&Ie++;let ge=$e(K[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Ie,le,ge.width,ge.height)}for(let ge=0;ge<6;ge++)if(L){Pe?re&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,0,0,K[ge].width,K[ge].height,he,oe,K[ge].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,le,K[ge].width,K[ge].height,0,he,oe,K[ge].data);for(let mt=0;mt<je.length;mt++){let Xi=je[mt].image[ge].image;Pe?re&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,mt+1,0,0,Xi.width,Xi.height,he,oe,Xi.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,mt+1,le,Xi.width,Xi.height,0,he,oe,Xi.data)}}else{Pe?re&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,0,0,he,oe,K[ge]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,le,he,oe,K[ge]);for(let mt=0;mt<je.length;mt++){let zt=je[mt];Pe?re&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,mt+1,0,0,he,oe,zt.image[ge]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,mt+1,le,he,oe,zt.image[ge])}}}S(_)&&_.mipmapsAutoUpdate===!0&&b(i.TEXTURE_CUBE_MAP),ae.__version=Q.version,_.onUpdate&&_.onUpdate(_)}C.__version=_.version}function Mt(C,_,B,se,Q,ae){let de=r.convert(B.format,B.colorSpace),Y=r.convert(B.type),j=R(B.internalFormat,de,Y,B.normalized,B.colorSpace),ce=n.get(_),L=n.get(B);if(L.__renderTarget=_,!ce.__hasExternalTextures){let K=Math.max(1,_.width>>ae),q=Math.max(1,_.height>>ae);Q===i.TEXTURE_3D||Q===i.TEXTURE_2D_ARRAY?t.texImage3D(Q,ae,j,K,q,_.depth,0,de,Y,null):t.texImage2D(Q,ae,j,K,q,0,de,Y,null)}t.bindFramebuffer(i.FRAMEBUFFER,C),me(_)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,se,Q,L.__webglTexture,0,wt(_)):(Q===i.TEXTURE_2D||Q>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&Q<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,se,Q,L.__webglTexture,ae),t.bindFramebuffer(i.FRAMEBUFFER,null)}function oi(C,_,B){if(i.bindRenderbuffer(i.RENDERBUFFER,C),_.depthBuffer){let se=_.depthTexture,Q=se&&se.isDepthTexture?se.type:null,ae=v(_.stencilBuffer,Q),de=_.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;me(_)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,wt(_),ae,_.width,_.height):B?i.renderbufferStorageMultisample(i.RENDERBUFFER,wt(_),ae,_.width,_.height):i.renderbufferStorage(i.RENDERBUFFER,ae,_.width,_.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,de,i.RENDERBUFFER,C)}else{let se=_.textures;for(let Q=0;Q<se.length;Q++){let ae=se[Q],de=r.convert(ae.format,ae.colorSpace),Y=r.convert(ae.type),j=R(ae.internalFormat,de,Y,ae.normalized,ae.colorSpace);me(_)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,wt(_),j,_.width,_.height):B?i.renderbufferStorageMultisample(i.RENDERBUFFER,wt(_),j,_.width,_.height):i.renderbufferStorage(i.RENDERBUFFER,j,_.width,_.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function Bt(C,_,B){let se=_.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,C),!(_.depthTexture&&_.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let Q=n.get(_.depthTexture);Q.__renderTarget=_;let ae=se?_.depthTexture.image[0]:_.depthTexture.image;(!Q.__webglTexture||ae.width!==_.width||ae.height!==_.height)&&(ae.width=_.width,ae.height=_.height,_.depthTexture.needsUpdate=!0),se?ve(_.depthTexture,0):xe(_.depthTexture,0);let de=Q.__webglTexture,Y=wt(_),j=se?i.TEXTURE_CUBE_MAP_POSITIVE_X+B:i.TEXTURE_2D,ce=_.depthTexture.format===ki?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(_.depthTexture.format===Pi)me(_)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ce,j,de,0,Y):i.framebufferTexture2D(i.FRAMEBUFFER,ce,j,de,0);else if(_.depthTexture.format===ki)me(_)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ce,j,de,0,Y):i.framebufferTexture2D(i.FRAMEBUFFER,ce,j,de,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Bn(C){let _=n.get(C),B=C.isWebGLCubeRenderTarget===!0;if(_.__boundDepthTexture!==C.depthTexture){let se=C.depthTexture;if(_.__depthDisposeCallback&&_.__depthDisposeCallback(),se){let Q=()=>{delete _.__boundDepthTexture,delete _.__depthDisposeCallback,se.removeEventListener("dispose",Q)};se.addEventListener("dispose",Q),_.__depthDisposeCallback=Q}_.__boundDepthTexture=se}if(C.depthTexture&&!_.__autoAllocateDepthBuffer)if(B)for(let se=0;se<6;se++)Bt(_.__webglFramebuffer[se],C,se);else C.texture.mipmaps.length>0?Bt(_.__webglFramebuffer[0],C,0):Bt(_.__webglFramebuffer,C,0);else if(B){_.__webglDepthbuffer=[];for(let se=0;se<6;se++)if(t.bindFramebuffer(i.FRAMEBUFFER,_.__webglFramebuffer[se]),_.__webglDepthbuffer[se]===void 0)_.__webglDepthbuffer[se]=i.createRenderbuffer(),oi(_.__webglDepthbuffer[se],C,!1);else{let Q=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ae=_.__webglDepthbuffer[se];i.bindRenderbuffer(i.RENDERBUFFER,ae),i.framebufferRenderbuffer(i.FRAMEBUFFER,Q,i.RENDERBUFFER,ae)}}else if(C.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,_.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,_.__webglFramebuffer),_.__webglDepthbuffer===void 0)_.__webglDepthbuffer=i.createRenderbuffer(),oi(_.__webglDepthbuffer,C,!1);else{let Q=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ae=_.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,ae),i.framebufferRenderbuffer(i.FRAMEBUFFER,Q,i.RENDERBUFFER,ae)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function zn(C,_,B){let se=n.get(C);_!==void 0&&Mt(se.__webglFramebuffer,C,C.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),B!==void 0&&Bn(C)}function Vn(C){let _=C.texture,B=n.get(C),se=n.get(_);C.addEventListener("dispose",O),D(C);let Q=C.textures,ae=C.isWebGLCubeRenderTarget===!0,de=Q.length>1;if(de||(se.__webglTexture===void 0&&(se.__webglTexture=i.createTexture()),se.__version=_.version,o.memory.textures++),ae){B.__webglFramebuffer=[];for(let Y=0;Y<6;Y++)if(_.mipmaps.length>0){B.__webglFramebuffer[Y]=[];for(let j=0;j<_.mipmaps.length;j++)B.__webglFramebuffer[Y][j]=i.createFramebuffer()}else B.__webglFramebuffer[Y]=i.createFramebuffer()}else{if(_.mipmaps.length>0){B.__webglFramebuffer=[];for(let Y=0;Y<_.mipmaps.length;Y++)B.__webglFramebuffer[Y]=i.createFramebuffer()}else B.__webglFramebuffer=i.createFramebuffer();if(de)for(let Y=0,j=Q.length;Y<j;Y++){let ce=n.get(Q[Y]);ce.__webglTexture===void 0&&(ce.__webglTexture=i.createTexture(),o.memory.textures++)}if(C.samples>0&&me(C)===!1){B.__webglMultisampledFramebuffer=i.createFramebuffer(),B.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,B.__webglMultisampledFramebuffer);for(let Y=0;Y<Q.length;Y++){let j=Q[Y];B.__webglColorRenderbuffer[Y]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,B.__webglColorRenderbuffer[Y]);let ce=r.convert(j.format,j.colorSpace),L=r.convert(j.type),K=R(j.internalFormat,ce,L,j.normalized,j.colorSpace,C.isXRRenderTarget===!0),q=wt(C);i.renderbufferStorageMultisample(i.RENDERBUFFER,q,K,C.width,C.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Y,i.RENDERBUFFER,B.__webglColorRenderbuffer[Y])}i.bindRenderbuffer(i.RENDERBUFFER,null),C.depthBuffer&&(B.__webglDepthRenderbuffer=i.createRenderbuffer(),oi(B.__webglDepthRenderbuffer,C,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(ae){t.bindTexture(i.TEXTURE_CUBE_MAP,se.__webglTexture),pt(i.TEXTURE_CUBE_MAP,_);for(let Y=0;Y<6;Y++)if(_.mipmaps.length>0)for(let j=0;j<_.mipmaps.length;j++)Mt(B.__webglFramebuffer[Y][j],C,_,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+Y,j);else Mt(B.__webglFramebuffer[Y],C,_,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+Y,0);S(_)?b(i.TEXTURE_CUBE_MAP):_.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,_.mipmaps.length-1),t.unbindTexture()}else if(de){for(let Y=0,j=Q.length;Y<j;Y++){let ce=Q[Y],L=n.get(ce),K=i.TEXTURE_2D;(C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(K=C.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(K,L.__webglTexture),pt(K,ce),Mt(B.__webglFramebuffer,C,ce,i.COLOR_ATTACHMENT0+Y,K,0),S(ce)&&b(K)}t.unbindTexture()}else{let Y=i.TEXTURE_2D;if((C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(Y=C.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(Y,se.__webglTexture),pt(Y,_),_.mipmaps.length>0)for(let j=0;j<_.mipmaps.length;j++)Mt(B.__webglFramebuffer[j],C,_,i.COLOR_ATTACHMENT0,Y,j);else Mt(B.__webglFramebuffer,C,_,i.COLOR_ATTACHMENT0,Y,0);S(_)?b(Y):_.mipmaps.length>0&&i.texParameteri(Y,i.TEXTURE_MAX_LEVEL,_.mipmaps.length-1),t.unbindTexture()}C.depthBuffer&&Bn(C)}function U(C){let _=C.textures;for(let B=0,se=_.length;B<se;B++){let Q=_[B];if(S(Q)&&Q.mipmapsAutoUpdate===!0){let ae=A(C),de=n.get(Q).__webglTexture;t.bindTexture(ae,de),b(ae),t.unbindTexture()}}}let Gn=[];function _t(C){if(C.samples>0){if(me(C)===!1){let _=C.textures,B=C.width,se=C.height,Q=i.COLOR_BUFFER_BIT,ae=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,de=n.get(C),Y=_.length>1;if(Y)for(let ce=0;ce<_.length;ce++)t.bindFramebuffer(i.FRAMEBUFFER,de.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ce,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,de.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+ce,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,de.__webglMultisampledFramebuffer),C.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,de.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,de.__webglFramebuffer);for(let ce=0;ce<_.length;ce++){if(C.resolveDepthBuffer&&(C.depthBuffer&&(Q|=i.DEPTH_BUFFER_BIT),C.stencilBuffer&&C.resolveStencilBuffer&&(Q|=i.STENCIL_BUFFER_BIT)),Y){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,de.__webglColorRenderbuffer[ce]);let L=n.get(_[ce]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,L,0)}i.blitFramebuffer(0,0,B,se,0,0,B,se,Q,i.NEAREST),l===!0&&(Gn.length=0,Gn.push(i.COLOR_ATTACHMENT0+ce),C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&Gn.push(ae),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Gn))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),Y)for(let ce=0;ce<_.length;ce++){t.bindFramebuffer(i.FRAMEBUFFER,de.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ce,i.RENDERBUFFER,de.__webglColorRenderbuffer[ce]);let L=n.get(_[ce]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,de.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+ce,i.TEXTURE_2D,L,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,de.__webglMultisampledFramebuffer)}else if(C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&l){let _=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[_])}}}function wt(C){return Math.min(s.maxSamples,C.samples)}function me(C){let _=n.get(C);return C.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&_.__useRenderToTexture!==!1}function Dt(C){let _=o.render.frame;h.get(C)!==_&&(h.set(C,_),C.update())}function Ue(C,_){let B=C.colorSpace,se=C.format,Q=C.type;return C.isCompressedTexture===!0||C.isVideoTexture===!0||B!==jo&&B!==Oi&&(it.getTransfer(B)===dt?(se!==si||Q!==Tn)&&De("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Ve("WebGLTextures: Unsupported texture color space:",B)),_}function $e(C){return typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement?(c.width=C.naturalWidth||C.width,c.height=C.naturalHeight||C.height):typeof VideoFrame<"u"&&C instanceof VideoFrame?(c.width=C.displayWidth,c.height=C.displayHeight):(c.width=C.width,c.height=C.height),c}this.allocateTextureUnit=ke,this.resetTextureUnits=J,this.getTextureUnits=ee,this.setTextureUnits=we,this.setTexture2D=xe,this.setTexture2DArray=Te,this.setTexture3D=Oe,this.setTextureCube=ve,this.rebindTextures=zn,this.setupRenderTarget=Vn,this.updateRenderTargetMipmap=U,this.updateMultisampleRenderTarget=_t,this.setupDepthRenderbuffer=Bn,this.setupFrameBufferTexture=Mt,this.useMultisampledRTT=me,this.dispose=H}function hT(i,e){function t(n,s=Oi){let r,o=it.getTransfer(s);if(n===Tn)return i.UNSIGNED_BYTE;if(n===th)return i.UNSIGNED_SHORT_4_4_4_4;if(n===nh)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Sf)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Tf)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===wf)return i.BYTE;if(n===Mf)return i.SHORT;if(n===Kr)return i.UNSIGNED_SHORT;if(n===eh)return i.INT;if(n===ni)return i.UNSIGNED_INT;if(n===Xn)return i.FLOAT;if(n===ii)return i.HALF_FLOAT;if(n===Ef)return i.ALPHA;if(n===Af)return i.RGB;if(n===si)return i.RGBA;if(n===Pi)return i.DEPTH_COMPONENT;if(n===ki)return i.DEPTH_STENCIL;if(n===ih)return i.RED;if(n===sh)return i.RED_INTEGER;if(n===hs)return i.RG;if(n===rh)return i.RG_INTEGER;if(n===oh)return i.RGBA_INTEGER;if(n===Fa||n===Ba||n===za||n===Va)if(o===dt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Fa)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Ba)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===za)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Va)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Fa)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Ba)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===za)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Va)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===ah||n===lh||n===ch||n===hh)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===ah)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===lh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===ch)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===hh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===uh||n===dh||n===fh||n===ph||n===mh||n===Ga||n===gh)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===uh||n===dh)return o===dt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===fh)return o===dt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===ph)return r.COMPRESSED_R11_EAC;if(n===mh)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Ga)return r.COMPRESSED_RG11_EAC;if(n===gh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===xh||n===yh||n===vh||n===bh||n===_h||n===wh||n===Mh||n===Sh||n===Th||n===Eh||n===Ah||n===Rh||n===Ch||n===Ph)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===xh)return o===dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===yh)return o===dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===vh)return o===dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===bh)return o===dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===_h)return o===dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===wh)return o===dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Mh)return o===dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Sh)return o===dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Th)return o===dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Eh)return o===dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Ah)return o===dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Rh)return o===dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Ch)return o===dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Ph)return o===dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Ih||n===Lh||n===Dh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===Ih)return o===dt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Lh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Dh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Nh||n===kh||n===Ha||n===Oh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===Nh)return r.COMPRESSED_RED_RGTC1_EXT;if(n===kh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Ha)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Oh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Xs?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var uT=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,dT=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Jf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new ua(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new $n({vertexShader:uT,fragmentShader:dT,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new st(new Fs(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Qf=class extends ei{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,d=null,f=null,p=null,x=typeof XRWebGLBinding<"u",g=new Jf,m={},y=t.getContextAttributes(),S=null,b=null,A=[],R=[],v=new te,T=null,D=null,P=new pn;P.viewport=new ft;let k=new pn;k.viewport=new ft;let O=[P,k],z=new jc,I=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Z){let xe=A[Z];return xe===void 0&&(xe=new Ur,A[Z]=xe),xe.getTargetRaySpace()},this.getControllerGrip=function(Z){let xe=A[Z];return xe===void 0&&(xe=new Ur,A[Z]=xe),xe.getGripSpace()},this.getHand=function(Z){let xe=A[Z];return xe===void 0&&(xe=new Ur,A[Z]=xe),xe.getHandSpace()};function X(Z){let xe=R.indexOf(Z.inputSource);if(xe===-1)return;let Te=A[xe];Te!==void 0&&(Te.update(Z.inputSource,Z.frame,c||o),Te.dispatchEvent({type:Z.type,data:Z.inputSource}))}function G(){s.removeEventListener("select",X),s.removeEventListener("selectstart",X),s.removeEventListener("selectend",X),s.removeEventListener("squeeze",X),s.removeEventListener("squeezestart",X),s.removeEventListener("squeezeend",X),s.removeEventListener("end",G),s.removeEventListener("inputsourceschange",ne);for(let Z=0;Z<A.length;Z++){let xe=R[Z];xe!==null&&(R[Z]=null,A[Z].disconnect(xe))}I=null,H=null,g.reset();for(let Z in m)delete m[Z];if(e.setRenderTarget(S),f=null,d=null,u=null,s=null,b=null,ke.stop(),n.isPresenting=!1,e.setPixelRatio(T),e.setSize(v.width,v.height,!1),D!==null){let Z=D.camera;Z.fov=D.fov,Z.zoom=D.zoom,Z.updateProjectionMatrix(),D=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Z){r=Z,n.isPresenting===!0&&De("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Z){a=Z,n.isPresenting===!0&&De("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Z){c=Z},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&x&&(u=new XRWebGLBinding(s,t)),u},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(Z){if(s=Z,s!==null){if(S=e.getRenderTarget(),s.addEventListener("select",X),s.addEventListener("selectstart",X),s.addEventListener("selectend",X),s.addEventListener("squeeze",X),s.addEventListener("squeezestart",X),s.addEventListener("squeezeend",X),s.addEventListener("end",G),s.addEventListener("inputsourceschange",ne),y.xrCompatible!==!0&&await t.makeXRCompatible(),T=e.getPixelRatio(),e.getSize(v),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let Te=null,Oe=null,ve=null;y.depth&&(ve=y.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,Te=y.stencil?ki:Pi,Oe=y.stencil?Xs:ni);let Ze={colorFormat:t.RGBA8,depthFormat:ve,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(Ze),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),b=new Dn(d.textureWidth,d.textureHeight,{format:si,type:Tn,depthTexture:new Ii(d.textureWidth,d.textureHeight,Oe,void 0,void 0,void 0,void 0,void 0,void 0,Te),stencilBuffer:y.stencil,colorSpace:e.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let Te={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,Te),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),b=new Dn(f.framebufferWidth,f.framebufferHeight,{format:si,type:Tn,colorSpace:e.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ke.setContext(s),ke.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function ne(Z){for(let xe=0;xe<Z.removed.length;xe++){let Te=Z.removed[xe],Oe=R.indexOf(Te);Oe>=0&&(R[Oe]=null,A[Oe].disconnect(Te))}for(let xe=0;xe<Z.added.length;xe++){let Te=Z.added[xe],Oe=R.indexOf(Te);if(Oe===-1){for(let Ze=0;Ze<A.length;Ze++)if(Ze>=R.length){R.push(Te),Oe=Ze;break}else if(R[Ze]===null){R[Ze]=Te,Oe=Ze;break}if(Oe===-1)break}let ve=A[Oe];ve&&ve.connect(Te)}}function $(Z,xe){xe===null?Z.matrixWorld.copy(Z.matrix):Z.matrixWorld.multiplyMatrices(xe.matrixWorld,Z.matrix),Z.matrixWorldInverse.copy(Z.matrixWorld).invert()}this.updateCamera=function(Z){if(s===null)return;let xe=Z.near,Te=Z.far;g.texture!==null&&(g.depthNear>0&&(xe=g.depthNear),g.depthFar>0&&(Te=g.depthFar)),z.near=k.near=P.near=xe,z.far=k.far=P.far=Te,(I!==z.near||H!==z.far)&&(s.updateRenderState({depthNear:z.near,depthFar:z.far}),I=z.near,H=z.far),z.layers.mask=Z.layers.mask|6,P.layers.mask=z.layers.mask&-5,k.layers.mask=z.layers.mask&-3;let Oe=Z.parent,ve=z.cameras;$(z,Oe);for(let Ze=0;Ze<ve.length;Ze++)$(ve[Ze],Oe);z.projectionMatrix.copy(P.projectionMatrix),z.projectionMatrixInverse.copy(P.projectionMatrixInverse),D===null&&Z.isPerspectiveCamera&&(D={camera:Z,fov:Z.fov,zoom:Z.zoom}),J(Z,z,Oe)};function J(Z,xe,Te){Te===null?Z.matrix.copy(xe.matrixWorld):(Z.matrix.copy(Te.matrixWorld),Z.matrix.invert(),Z.matrix.multiply(xe.matrixWorld)),Z.matrix.decompose(Z.position,Z.quaternion,Z.scale),Z.updateMatrixWorld(!0),Z.projectionMatrix.copy(xe.projectionMatrix),Z.projectionMatrixInverse.copy(xe.projectionMatrixInverse),Z.isPerspectiveCamera&&(Z.fov=kr*2*Math.atan(1/Z.projectionMatrix.elements[5]),Z.zoom=1)}this.getCamera=function(){return z},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(Z){l=Z,d!==null&&(d.fixedFoveation=Z),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=Z)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(z)},this.getCameraTexture=function(Z){return m[Z]};let ee=null;function we(Z,xe){if(h=xe.getViewerPose(c||o),p=xe,h!==null){let Te=h.views;f!==null&&(e.setRenderTargetFramebuffer(b,f.framebuffer),e.setRenderTarget(b));let Oe=!1;Te.length!==z.cameras.length&&(z.cameras.length=0,Oe=!0);for(let Fe=0;Fe<Te.length;Fe++){let pt=Te[Fe],xt=null;if(f!==null)xt=f.getViewport(pt);else{let qt=u.getViewSubImage(d,pt);xt=qt.viewport,Fe===0&&(e.setRenderTargetTextures(b,qt.colorTexture,qt.depthStencilTexture),e.setRenderTarget(b))}let et=O[Fe];et===void 0&&(et=new pn,et.layers.enable(Fe),et.viewport=new ft,O[Fe]=et),et.matrix.fromArray(pt.transform.matrix),et.matrix.decompose(et.position,et.quaternion,et.scale),et.projectionMatrix.fromArray(pt.projectionMatrix),et.projectionMatrixInverse.copy(et.projectionMatrix).invert(),et.viewport.set(xt.x,xt.y,xt.width,xt.height),Fe===0&&(z.matrix.copy(et.matrix),z.matrix.decompose(z.position,z.quaternion,z.scale)),Oe===!0&&z.cameras.push(et)}let ve=s.enabledFeatures;if(ve&&ve.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){u=n.getBinding();let Fe=u.getDepthInformation(Te[0]);Fe&&Fe.isValid&&Fe.texture&&g.init(Fe,s.renderState)}if(ve&&ve.includes("camera-access")&&x){e.state.unbindTexture(),u=n.getBinding();for(let Fe=0;Fe<Te.length;Fe++){let pt=Te[Fe].camera;if(pt){let xt=m[pt];xt||(xt=new ua,m[pt]=xt);let et=u.getCameraImage(pt);xt.sourceTexture=et}}}}for(let Te=0;Te<A.length;Te++){let Oe=R[Te],ve=A[Te];Oe!==null&&ve!==void 0&&ve.update(Oe,xe,c||o)}ee&&ee(Z,xe),xe.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:xe}),p=null}let ke=new W0;ke.setAnimationLoop(we),this.setAnimationLoop=function(Z){ee=Z},this.dispose=function(){}}},fT=new Le,ex=new He;ex.set(-1,0,0,0,1,0,0,0,1);function pT(i,e){function t(g,m){g.matrixAutoUpdate===!0&&g.updateMatrix(),m.value.copy(g.matrix)}function n(g,m){m.color.getRGB(g.fogColor.value,zf(i)),m.isFog?(g.fogNear.value=m.near,g.fogFar.value=m.far):m.isFogExp2&&(g.fogDensity.value=m.density)}function s(g,m,y,S,b){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(g,m):m.isMeshLambertMaterial?(r(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(g,m),u(g,m)):m.isMeshPhongMaterial?(r(g,m),h(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(g,m),d(g,m),m.isMeshPhysicalMaterial&&f(g,m,b)):m.isMeshMatcapMaterial?(r(g,m),p(g,m)):m.isMeshDepthMaterial?r(g,m):m.isMeshDistanceMaterial?(r(g,m),x(g,m)):m.isMeshNormalMaterial?r(g,m):m.isLineBasicMaterial?(o(g,m),m.isLineDashedMaterial&&a(g,m)):m.isPointsMaterial?l(g,m,y,S):m.isSpriteMaterial?c(g,m):m.isShadowMaterial?(g.color.value.copy(m.color),g.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(g,m){g.opacity.value=m.opacity,m.color&&g.diffuse.value.copy(m.color),m.emissive&&g.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(g.map.value=m.map,t(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.bumpMap&&(g.bumpMap.value=m.bumpMap,t(m.bumpMap,g.bumpMapTransform),g.bumpScale.value=m.bumpScale,m.side===xn&&(g.bumpScale.value*=-1)),m.normalMap&&(g.normalMap.value=m.normalMap,t(m.normalMap,g.normalMapTransform),g.normalScale.value.copy(m.normalScale),m.side===xn&&g.normalScale.value.negate()),m.displacementMap&&(g.displacementMap.value=m.displacementMap,t(m.displacementMap,g.displacementMapTransform),g.displacementScale.value=m.displacementScale,g.displacementBias.value=m.displacementBias),m.emissiveMap&&(g.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,g.emissiveMapTransform)),m.specularMap&&(g.specularMap.value=m.specularMap,t(m.specularMap,g.specularMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest);let y=e.get(m),S=y.envMap,b=y.envMapRotation;S&&(g.envMap.value=S,g.envMapRotation.value.setFromMatrix4(fT.makeRotationFromEuler(b)).transpose(),S.isCubeTexture&&S.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(ex),g.reflectivity.value=m.reflectivity,g.ior.value=m.ior,g.refractionRatio.value=m.refractionRatio),m.lightMap&&(g.lightMap.value=m.lightMap,g.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,g.lightMapTransform)),m.aoMap&&(g.aoMap.value=m.aoMap,g.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,g.aoMapTransform))}function o(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,m.map&&(g.map.value=m.map,t(m.map,g.mapTransform))}function a(g,m){g.dashSize.value=m.dashSize,g.totalSize.value=m.dashSize+m.gapSize,g.scale.value=m.scale}function l(g,m,y,S){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.size.value=m.size*y,g.scale.value=S*.5,m.map&&(g.map.value=m.map,t(m.map,g.uvTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function c(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.rotation.value=m.rotation,m.map&&(g.map.value=m.map,t(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function h(g,m){g.specular.value.copy(m.specular),g.shininess.value=Math.max(m.shininess,1e-4)}function u(g,m){m.gradientMap&&(g.gradientMap.value=m.gradientMap)}function d(g,m){g.metalness.value=m.metalness,m.metalnessMap&&(g.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,g.metalnessMapTransform)),g.roughness.value=m.roughness,m.roughnessMap&&(g.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,g.roughnessMapTransform)),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)}function f(g,m,y){g.ior.value=m.ior,m.diffuseRoughness>0&&(g.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=m.diffuseRoughnessMap,t(m.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),m.sheen>0&&(g.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),g.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(g.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,g.sheenColorMapTransform)),m.sheenRoughnessMap&&(g.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,g.sheenRoughnessMapTransform))),m.clearcoat>0&&(g.clearcoat.value=m.clearcoat,g.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(g.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,g.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(g.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===xn&&g.clearcoatNormalScale.value.negate())),m.dispersion>0&&(g.dispersion.value=m.dispersion),m.retroreflectivity>0&&(g.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(g.iridescence.value=m.iridescence,g.iridescenceIOR.value=m.iridescenceIOR,g.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(g.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,g.iridescenceMapTransform)),m.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),m.transmission>0&&(g.transmission.value=m.transmission,g.transmissionSamplerMap.value=y.texture,g.transmissionSamplerSize.value.set(y.width,y.height),m.transmissionMap&&(g.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,g.transmissionMapTransform)),g.thickness.value=m.thickness,m.thicknessMap&&(g.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=m.attenuationDistance,g.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(g.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(g.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=m.specularIntensity,g.specularColor.value.copy(m.specularColor),m.specularColorMap&&(g.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,g.specularColorMapTransform)),m.specularIntensityMap&&(g.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,g.specularIntensityMapTransform))}function p(g,m){m.matcap&&(g.matcap.value=m.matcap)}function x(g,m){let y=e.get(m).light;g.referencePosition.value.setFromMatrixPosition(y.matrixWorld),g.nearDistance.value=y.shadow.camera.near,g.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function mT(i,e,t,n){let s={},r={};function o(y,S){let b=S.program;n.uniformBlockBinding(y,b,s[y.id])}function a(y,S){let b=s[y.id];b===void 0&&(p(y),b=l(y),s[y.id]=b,y.addEventListener("dispose",g));let A=S.program;n.updateUBOMapping(y,A);let R=e.render.frame;r[y.id]!==R&&(c(y),r[y.id]=R)}function l(y){let S=i.createBuffer(),b=y.__size,A=y.usage;return i.bindBuffer(i.UNIFORM_BUFFER,S),i.bufferData(i.UNIFORM_BUFFER,b,A),i.bindBuffer(i.UNIFORM_BUFFER,null),S}function c(y){let S=s[y.id],b=y.uniforms,A=y.__cache;i.bindBuffer(i.UNIFORM_BUFFER,S);for(let R=0,v=b.length;R<v;R++){let T=b[R];if(Array.isArray(T))for(let D=0,P=T.length;D<P;D++)h(T[D],R,D,A);else h(T,R,0,A)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(y,S,b,A){if(d(y,S,b,A)===!0){let R=y.__offset,v=y.value;if(Array.isArray(v)){let T=0;for(let D=0;D<v.length;D++){let P=v[D],k=x(P,!0);u(P,y.__data,T),T+=k.storage/Float32Array.BYTES_PER_ELEMENT}}else u(v,y.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,R,y.__data)}}function u(y,S,b){typeof y=="number"||typeof y=="boolean"?S[b]=y:y.isMatrix3?(S[b]=y.elements[0],S[b+1]=y.elements[1],S[b+2]=y.elements[2],S[b+3]=0,S[b+4]=y.elements[3],S[b+5]=y.elements[4],S[b+6]=y.elements[5],S[b+7]=0,S[b+8]=y.elements[6],S[b+9]=y.elements[7],S[b+10]=y.elements[8],S[b+11]=0):ArrayBuffer.isView(y)?S.set(y.subarray(0,S.length-b),b):y.toArray(S,b)}function d(y,S,b,A){let R=y.value,v=S+"_"+b;if(Array.isArray(R)){A[v]===void 0&&(A[v]=[]);let T=A[v],D=!1;for(let P=0;P<R.length;P++)f(R[P],T,P)===!0&&(D=!0);return D}return f(R,A,v)}function f(y,S,b){if(S[b]===void 0)return typeof y=="number"||typeof y=="boolean"?S[b]=y:ArrayBuffer.isView(y)?S[b]=y.slice():S[b]=y.clone(),!0;{let A=S[b];if(typeof y=="number"||typeof y=="boolean"){if(A!==y)return S[b]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(A.equals(y)===!1)return A.copy(y),!0}}return!1}function p(y){let S=y.uniforms,b=0,A=16;for(let v=0,T=S.length;v<T;v++){let D=Array.isArray(S[v])?S[v]:[S[v]];for(let P=0,k=D.length;P<k;P++){let O=D[P],z=Array.isArray(O.value)?O.value:[O.value],I=Array.isArray(S[v])||Array.isArray(O.value),H=b;for(let G=0,ne=z.length;G<ne;G++){let $=z[G],J=x($,I),ee=b%A,we=ee%J.boundary,ke=ee+we;b+=we,ke!==0&&A-ke<J.storage&&(b+=A-ke),G===0&&(H=b),b+=J.storage}let X=O.type==="int"?Int32Array:O.type==="uint"?Uint32Array:Float32Array;O.__data=new X((b-H)/Float32Array.BYTES_PER_ELEMENT),O.__offset=H}}let R=b%A;return R>0&&(b+=A-R),y.__size=b,y.__cache={},this}function x(y,S){let b={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(b.boundary=4,b.storage=4):y.isVector2?(b.boundary=8,b.storage=8):y.isVector3||y.isColor?(b.boundary=16,b.storage=12):y.isVector4?(b.boundary=16,b.storage=16):y.isMatrix3?(b.boundary=16,b.storage=48):y.isMatrix4?(b.boundary=16,b.storage=64):y.isTexture?De("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(b.boundary=16,b.storage=y.byteLength):De("WebGLRenderer: Unsupported uniform value type.",y),S===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function g(y){let S=y.target;S.removeEventListener("dispose",g),i.deleteBuffer(s[S.id]),delete s[S.id],delete r[S.id]}function m(){for(let y in s)i.deleteBuffer(s[y]);s={},r={}}return{bind:o,update:a,dispose:m}}var gT=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),mi=null;function xT(){return mi===null&&(mi=new oa(gT,16,16,hs,ii),mi.name="DFG_LUT",mi.minFilter=mn,mi.magFilter=mn,mi.wrapS=di,mi.wrapT=di,mi.generateMipmaps=!1,mi.needsUpdate=!0),mi}var Vh=class{constructor(e={}){let{canvas:t=u0(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=Tn}=e;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=o;let x=f,g=new Set([oh,rh,sh]),m=new Set([Tn,ni,Kr,Xs,th,nh]),y=new Uint32Array(4),S=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},A=null,R=null,v=[],T=[],D=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=pi,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let P=this,k=!1,O=null,z=null,I=null,H=null;this._outputColorSpace=jt;let X=0,G=0,ne=null,$=-1,J=null,ee=new ft,we=new ft,ke=null,Z=new Re(0),xe=0,Te=t.width,Oe=t.height,ve=1,Ze=null,Ct=null,Fe=new ft(0,0,Te,Oe),pt=new ft(0,0,Te,Oe),xt=!1,et=new es,qt=new Ec,Lt=!1,_n=!1,Mt=new Le,oi=new E,Bt=new ft,Bn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},zn=!1;function Vn(){return ne===null?ve:1}let U=n;function Gn(w,N){return t.getContext(w,N)}let _t,wt,me,Dt,Ue,$e,C,_,B,se,Q,ae,de,Y,j,ce,L,K,q,he,oe,le,Pe;try{let w={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Ie,!1),t.addEventListener("webglcontextrestored",je,!1),t.addEventListener("webglcontextcreationerror",ge,!1),U===null){let N="webgl2";if(U=Gn(N,w),U===null)throw Gn(N)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Ke()}catch(w){throw t.removeEventListener("webglcontextlost",Ie,!1),t.removeEventListener("webglcontextrestored",je,!1),t.removeEventListener("webglcontextcreationerror",ge,!1),Ve("WebGLRenderer: "+w.message),w}function Ke(){_t=new RS(U),_t.init(),oe=new hT(U,_t),wt=new xS(U,_t,e,oe),me=new lT(U,_t),wt.reversedDepthBuffer&&d&&me.buffers.depth.setReversed(!0),z=U.createFramebuffer(),I=U.createFramebuffer(),H=U.createFramebuffer(),Dt=new IS(U),Ue=new Y1,$e=new cT(U,_t,me,Ue,wt,oe,Dt),C=new AS(P),_=new D_(U),le=new mS(U,_),B=new CS(U,_,Dt,le),se=new DS(U,B,_,le,Dt),K=new LS(U,wt,$e),j=new yS(Ue),Q=new q1(P,C,_t,wt,le,j),ae=new pT(P,Ue),de=new j1,Y=new nT(_t),L=new pS(P,C,me,se,p,l),ce=new aT(P,se,wt),Pe=new mT(U,Dt,wt,me),q=new gS(U,_t,Dt),he=new PS(U,_t,Dt),Dt.programs=Q.programs,P.capabilities=wt,P.extensions=_t,P.properties=Ue,P.renderLists=de,P.shadowMap=ce,P.state=me,P.info=Dt}x!==Tn&&(D=new kS(x,t.width,t.height,a,s,r));let re=new Qf(P,U);this.xr=re,this.getContext=function(){return U},this.getContextAttributes=function(){return U.getContextAttributes()},this.forceContextLoss=function(){let w=_t.get("WEBGL_lose_context");w&&w.loseContext()},this.forceContextRestore=function(){let w=_t.get("WEBGL_lose_context");w&&w.restoreContext()},this.getPixelRatio=function(){return ve},this.setPixelRatio=function(w){w!==void 0&&(ve=w,this.setSize(Te,Oe,!1))},this.getSize=function(w){return w.set(Te,Oe)},this.setSize=function(w,N,W=!0){if(re.isPresenting){De("WebGLRenderer: Can't change size while VR device is presenting.");return}Te=w,Oe=N,t.width=Math.floor(w*ve),t.height=Math.floor(N*ve),W===!0&&(t.style.width=w+"px",t.style.height=N+"px"),D!==null&&D.setSize(t.width,t.height),this.setViewport(0,0,w,N)},this.getDrawingBufferSize=function(w){return w.set(Te*ve,Oe*ve).floor()},this.setDrawingBufferSize=function(w,N,W){Te=w,Oe=N,ve=W,t.width=Math.floor(w*W),t.height=Math.floor(N*W),this.setViewport(0,0,w,N)},this.setEffects=function(w){if(x===Tn){Ve("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(w){for(let N=0;N<w.length;N++)if(w[N].isOutputPass===!0){De("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}D.setEffects(w||[])},this.getCurrentViewport=function(w){return w.copy(ee)},this.getViewport=function(w){return w.copy(Fe)},this.setViewport=function(w,N,W,F){w.isVector4?Fe.set(w.x,w.y,w.z,w.w):Fe.set(w,N,W,F),me.viewport(ee.copy(Fe).multiplyScalar(Vn()).round())},this.getScissor=function(w){return w.copy(pt)},this.setScissor=function(w,N,W,F){w.isVector4?pt.set(w.x,w.y,w.z,w.w):pt.set(w,N,W,F),me.scissor(we.copy(pt).multiplyScalar(Vn()).round())},this.getScissorTest=function(){return xt},this.setScissorTest=function(w){me.setScissorTest(xt=w)},this.setOpaqueSort=function(w){Ze=w},this.setTransparentSort=function(w){Ct=w},this.getClearColor=function(w){return w.copy(L.getClearColor())},this.setClearColor=function(){L.setClearColor(...arguments)},this.getClearAlpha=function(){return L.getClearAlpha()},this.setClearAlpha=function(){L.setClearAlpha(...arguments)},this.clear=function(w=!0,N=!0,W=!0){let F=0;if(w){let V=!1;if(ne!==null){let fe=ne.texture.format;V=g.has(fe)}if(V){let fe=ne.texture.type,Se=m.has(fe),ue=L.getClearColor(),be=L.getClearAlpha(),Ce=ue.r,qe=ue.g,tt=ue.b;Se?(y[0]=Ce,y[1]=qe,y[2]=tt,y[3]=be,U.clearBufferuiv(U.COLOR,0,y)):(S[0]=Ce,S[1]=qe,S[2]=tt,S[3]=be,U.clearBufferiv(U.COLOR,0,S))}else F|=U.COLOR_BUFFER_BIT}N&&(F|=U.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),W&&(F|=U.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),F!==0&&U.clear(F)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(w){w.setRenderer(this),O=w},this.dispose=function(){t.removeEventListener("webglcontextlost",Ie,!1),t.removeEventListener("webglcontextrestored",je,!1),t.removeEventListener("webglcontextcreationerror",ge,!1),L.dispose(),de.dispose(),Y.dispose(),$e.dispose(),Ue.dispose(),C.dispose(),se.dispose(),B.dispose(),le.dispose(),Pe.dispose(),Q.dispose(),re.dispose(),re.removeEventListener("sessionstart",Rm),re.removeEventListener("sessionend",Cm),Ts.stop()};function Ie(w){w.preventDefault(),Qo("WebGLRenderer: Context Lost."),k=!0}function je(){Qo("WebGLRenderer: Context Restored."),k=!1;let w=Dt.autoReset,N=ce.enabled,W=ce.autoUpdate,F=ce.needsUpdate,V=ce.type;Ke(),Dt.autoReset=w,ce.enabled=N,ce.autoUpdate=W,ce.needsUpdate=F,ce.type=V}function ge(w){Ve("WebGLRenderer: A WebGL context could not be created. Reason: ",w.statusMessage)}function mt(w){let N=w.target;N.removeEventListener("dispose",mt),zt(N)}function zt(w){Xi(w),Ue.remove(w)}function Xi(w){let N=Ue.get(w).programs;N!==void 0&&(N.forEach(function(W){Q.releaseProgram(W)}),w.isShaderMaterial&&Q.releaseShaderCache(w))}this.renderBufferDirect=function(w,N,W,F,V,fe){N===null&&(N=Bn);let Se=V.isMesh&&V.matrixWorld.determinantAffine()<0,ue=eb(w,N,W,F,V);me.setMaterial(F,Se);let be=W.index,Ce=1;if(F.wireframe===!0){if(be=B.getWireframeAttribute(W),be===void 0)return;Ce=2}let qe=W.drawRange,tt=W.attributes.position,Ee=qe.start*Ce,nt=(qe.start+qe.count)*Ce;fe!==null&&(Ee=Math.max(Ee,fe.start*Ce),nt=Math.min(nt,(fe.start+fe.count)*Ce)),be!==null?(Ee=Math.max(Ee,0),nt=Math.min(nt,be.count)):tt!=null&&(Ee=Math.max(Ee,0),nt=Math.min(nt,tt.count));let Pt=nt-Ee;if(Pt<0||Pt===1/0)return;le.setup(V,F,ue,W,be);let vt,yt=q;if(be!==null&&(vt=_.get(be),yt=he,yt.setIndex(vt)),V.isMesh)F.wireframe===!0?(me.setLineWidth(F.wireframeLinewidth*Vn()),yt.setMode(U.LINES)):yt.setMode(U.TRIANGLES);else if(V.isLine){let nn=F.linewidth;nn===void 0&&(nn=1),me.setLineWidth(nn*Vn()),V.isLineSegments?yt.setMode(U.LINES):V.isLineLoop?yt.setMode(U.LINE_LOOP):yt.setMode(U.LINE_STRIP)}else V.isPoints?yt.setMode(U.POINTS):V.isSprite&&yt.setMode(U.TRIANGLES);if(V.isBatchedMesh)if(_t.get("WEBGL_multi_draw"))yt.renderMultiDraw(V._multiDrawStarts,V._multiDrawCounts,V._multiDrawCount);else{let nn=V._multiDrawStarts,Ae=V._multiDrawCounts,dn=V._multiDrawCount,at=be?_.get(be).bytesPerElement:1,Es=Ue.get(F).currentProgram.getUniforms();for(let sn=0;sn<dn;sn++)Es.setValue(U,"_gl_DrawID",sn),yt.render(nn[sn]/at,Ae[sn])}else if(V.isInstancedMesh)yt.renderInstances(Ee,Pt,V.count);else if(W.isInstancedBufferGeometry){let nn=W._maxInstanceCount!==void 0?W._maxInstanceCount:1/0,Ae=Math.min(W.instanceCount,nn);yt.renderInstances(Ee,Pt,Ae)}else yt.render(Ee,Pt)};function Am(w,N,W,F){O!==null&&w.isNodeMaterial&&O.setObject(F,w),Lt===!0&&j.setState(w,W,!1),w.transparent===!0&&w.side===hn&&w.forceSinglePass===!1?(w.side=xn,w.needsUpdate=!0,Co(w,N,F),w.side=cs,w.needsUpdate=!0,Co(w,N,F),w.side=hn):Co(w,N,F)}this.compile=function(w,N,W=null){W===null&&(W=w),O!==null&&O.renderStart(w,N,W),R=Y.get(W),R.init(N),T.push(R),W.traverseVisible(function(V){V.isLight&&V.layers.test(N.layers)&&(R.pushLight(V),V.castShadow&&R.pushShadow(V))}),w!==W&&w.traverseVisible(function(V){V.isLight&&V.layers.test(N.layers)&&(R.pushLight(V),V.castShadow&&R.pushShadow(V))}),R.setupLights(),O!==null&&O.updateLights(R.state.lightsArray),_n=this.localClippingEnabled,Lt=j.init(this.clippingPlanes,_n),Lt===!0&&j.setGlobalState(this.clippingPlanes,N),O!==null&&ce.render(R.state.shadowsArray,W,N);let F=new Set;return w.traverse(function(V){if(!(V.isMesh||V.isPoints||V.isLine||V.isSprite))return;let fe=V.material;if(fe)if(Array.isArray(fe))for(let Se=0;Se<fe.length;Se++){let ue=fe[Se];Am(ue,W,N,V),F.add(ue)}else Am(fe,W,N,V),F.add(fe)}),R=T.pop(),O!==null&&O.renderEnd(),F},this.compileAsync=function(w,N,W=null){let F=this.compile(w,N,W);return new Promise(V=>{function fe(){if(F.forEach(function(Se){let be=Ue.get(Se).currentProgram;(be===void 0||be.isReady())&&F.delete(Se)}),F.size===0){V(w);return}setTimeout(fe,10)}_t.get("KHR_parallel_shader_compile")!==null?fe():setTimeout(fe,10)})};let _d=null;function Jv(w){_d&&_d(w)}function Rm(){Ts.stop()}function Cm(){Ts.start()}let Ts=new W0;Ts.setAnimationLoop(Jv),typeof self<"u"&&Ts.setContext(self),this.setAnimationLoop=function(w){_d=w,re.setAnimationLoop(w),w===null?Ts.stop():Ts.start()},re.addEventListener("sessionstart",Rm),re.addEventListener("sessionend",Cm),this.render=function(w,N){if(N!==void 0&&N.isCamera!==!0){Ve("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(k===!0)return;O!==null&&O.renderStart(w,N);let W=re.enabled===!0&&re.isPresenting===!0,F=D!==null&&(ne===null||W)&&D.begin(P,ne);if(w.matrixWorldAutoUpdate===!0&&w.updateMatrixWorld(),N.parent===null&&N.matrixWorldAutoUpdate===!0&&N.updateMatrixWorld(),re.enabled===!0&&re.isPresenting===!0&&(D===null||D.isCompositing()===!1)&&(re.cameraAutoUpdate===!0&&re.updateCamera(N),N=re.getCamera()),w.isScene===!0&&w.onBeforeRender(P,w,N,ne),R=Y.get(w,T.length),R.init(N),R.state.textureUnits=$e.getTextureUnits(),T.push(R),Mt.multiplyMatrices(N.projectionMatrix,N.matrixWorldInverse),N.isArrayCamera?qt.setFromArrayCamera(N):et.setFromProjectionMatrix(Mt,Wn,N.reversedDepth),_n=this.localClippingEnabled,Lt=j.init(this.clippingPlanes,_n),A=de.get(w,v.length),A.init(),v.push(A),this.info.render.frame++,re.enabled===!0&&re.isPresenting===!0){let Se=P.xr.getDepthSensingMesh();Se!==null&&wd(Se,N,-1/0,P.sortObjects)}wd(w,N,0,P.sortObjects),A.finish(),O!==null&&O.updateLights(R.state.lightsArray),P.sortObjects===!0&&A.sort(Ze,Ct),zn=re.enabled===!1||re.isPresenting===!1||re.hasDepthSensing()===!1,zn&&L.addToRenderList(A,w),this.info.autoReset===!0&&this.info.reset(),Lt===!0&&j.beginShadows();let V=R.state.shadowsArray;if(ce.render(V,w,N),Lt===!0&&j.endShadows(),(F&&D.hasRenderPass())===!1){let Se=A.opaque,ue=A.transmissive;if(R.setupLights(),N.isArrayCamera){let be=N.cameras;if(ue.length>0)for(let Ce=0,qe=be.length;Ce<qe;Ce++){let tt=be[Ce];Im(Se,ue,w,tt)}zn&&L.render(w);for(let Ce=0,qe=be.length;Ce<qe;Ce++){let tt=be[Ce];Pm(A,w,tt,tt.viewport)}}else ue.length>0&&Im(Se,ue,w,N),zn&&L.render(w),Pm(A,w,N)}ne!==null&&G===0&&($e.updateMultisampleRenderTarget(ne),$e.updateRenderTargetMipmap(ne)),F&&D.end(P),w.isScene===!0&&w.onAfterRender(P,w,N),le.resetDefaultState(),$=-1,J=null,T.pop(),T.length>0?(R=T[T.length-1],$e.setTextureUnits(R.state.textureUnits),Lt===!0&&j.setGlobalState(P.clippingPlanes,R.state.camera)):R=null,v.pop(),v.length>0?A=v[v.length-1]:A=null,O!==null&&O.renderEnd()};function wd(w,N,W,F){if(w.visible===!1)return;if(w.layers.test(N.layers)){if(w.isGroup)W=w.renderOrder;else if(w.isLOD)w.autoUpdate===!0&&w.update(N);else if(w.isLight)R.pushLight(w),w.castShadow&&R.pushShadow(w);else if(w.isSprite){let Se=N.isArrayCamera?qt:et;if(!w.frustumCulled||w.intersectsFrustum(Se)){F&&Bt.setFromMatrixPosition(w.matrixWorld).applyMatrix4(Mt);let ue=se.update(w),be=w.material;be.visible&&A.push(w,ue,be,W,Bt.z,null,N)}}else if(w.isMesh||w.isLine||w.isPoints){let Se=N.isArrayCamera?qt:et;if(!w.frustumCulled||w.intersectsFrustum(Se)){let ue=se.update(w),be=w.material;if(F&&(w.boundingSphere!==void 0?(w.boundingSphere===null&&w.computeBoundingSphere(),Bt.copy(w.boundingSphere.center)):(ue.boundingSphere===null&&ue.computeBoundingSphere(),Bt.copy(ue.boundingSphere.center)),Bt.applyMatrix4(w.matrixWorld).applyMatrix4(Mt)),Array.isArray(be)){let Ce=ue.groups;for(let qe=0,tt=Ce.length;qe<tt;qe++){let Ee=Ce[qe],nt=be[Ee.materialIndex];nt&&nt.visible&&A.push(w,ue,nt,W,Bt.z,Ee,N)}}else be.visible&&A.push(w,ue,be,W,Bt.z,null,N)}}}let fe=w.children;for(let Se=0,ue=fe.length;Se<ue;Se++)wd(fe[Se],N,W,F)}function Pm(w,N,W,F){let{opaque:V,transmissive:fe,transparent:Se}=w;R.setupLightsView(W),Lt===!0&&j.setGlobalState(P.clippingPlanes,W),F&&me.viewport(ee.copy(F)),V.length>0&&El(V,N,W),fe.length>0&&El(fe,N,W),Se.length>0&&El(Se,N,W),me.buffers.depth.setTest(!0),me.buffers.depth.setMask(!0),me.buffers.color.setMask(!0),me.setPolygonOffset(!1)}function Im(w,N,W,F){if((W.isScene===!0?W.overrideMaterial:null)!==null)return;if(R.state.transmissionRenderTarget[F.id]===void 0){let Ee=_t.has("EXT_color_buffer_half_float")||_t.has("EXT_color_buffer_float");R.state.transmissionRenderTarget[F.id]=new Dn(1,1,{generateMipmaps:!0,type:Ee?ii:Tn,minFilter:Ni,samples:Math.max(4,wt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:it.workingColorSpace})}let fe=R.state.transmissionRenderTarget[F.id],Se=F.viewport||ee;fe.setSize(Se.z*P.transmissionResolutionScale,Se.w*P.transmissionResolutionScale);let ue=P.getRenderTarget(),be=P.getActiveCubeFace(),Ce=P.getActiveMipmapLevel();P.setRenderTarget(fe),P.getClearColor(Z),xe=P.getClearAlpha(),xe<1&&P.setClearColor(16777215,.5),P.clear(),zn&&L.render(W);let qe=P.toneMapping;P.toneMapping=pi;let tt=F.viewport;if(F.viewport!==void 0&&(F.viewport=void 0),R.setupLightsView(F),Lt===!0&&j.setGlobalState(P.clippingPlanes,F),El(w,W,F),$e.updateMultisampleRenderTarget(fe),$e.updateRenderTargetMipmap(fe),_t.has("WEBGL_multisampled_render_to_texture")===!1){let Ee=!1;for(let nt=0,Pt=N.length;nt<Pt;nt++){let vt=N[nt],{object:yt,geometry:nn,material:Ae,group:dn}=vt;if(Ae.side===hn&&yt.layers.test(F.layers)){let at=Ae.side;Ae.side=xn,Ae.needsUpdate=!0,Lm(yt,W,F,nn,Ae,dn),Ae.side=at,Ae.needsUpdate=!0,Ee=!0}}Ee===!0&&($e.updateMultisampleRenderTarget(fe),$e.updateRenderTargetMipmap(fe))}P.setRenderTarget(ue,be,Ce),P.setClearColor(Z,xe),tt!==void 0&&(F.viewport=tt),P.toneMapping=qe}function El(w,N,W){let F=N.isScene===!0?N.overrideMaterial:null;for(let V=0,fe=w.length;V<fe;V++){let Se=w[V],{object:ue,geometry:be,group:Ce}=Se,qe=Se.material;qe.allowOverride===!0&&F!==null&&(qe=F),ue.layers.test(W.layers)&&Lm(ue,N,W,be,qe,Ce)}}function Lm(w,N,W,F,V,fe){O!==null&&V.isNodeMaterial&&O.setObject(w,V),w.onBeforeRender(P,N,W,F,V,fe),w.modelViewMatrix.multiplyMatrices(W.matrixWorldInverse,w.matrixWorld),w.normalMatrix.getNormalMatrix(w.modelViewMatrix),V.onBeforeRender(P,N,W,F,w,fe),V.transparent===!0&&V.side===hn&&V.forceSinglePass===!1?(V.side=xn,V.needsUpdate=!0,P.renderBufferDirect(W,N,F,V,w,fe),V.side=cs,V.needsUpdate=!0,P.renderBufferDirect(W,N,F,V,w,fe),V.side=hn):P.renderBufferDirect(W,N,F,V,w,fe),w.onAfterRender(P,N,W,F,V,fe)}function Dm(w){let N=0;for(let W of w)W.texture!==null&&N++;return N}function Co(w,N,W){N.isScene!==!0&&(N=Bn);let F=Ue.get(w),V=R.state.lights,fe=R.state.shadowsArray,Se=V.state.version,ue=Q.getParameters(w,V.state,fe,N,W,R.state.lightProbeGridArray),be=Q.getProgramCacheKey(ue),Ce=F.programs;F.environment=w.isMeshStandardMaterial||w.isMeshLambertMaterial||w.isMeshPhongMaterial?N.environment:null,F.fog=N.fog;let qe=w.isMeshStandardMaterial||w.isMeshLambertMaterial&&!w.envMap||w.isMeshPhongMaterial&&!w.envMap;F.envMap=C.get(w.envMap||F.environment,qe),F.envMapRotation=F.environment!==null&&w.envMap===null?N.environmentRotation:w.envMapRotation,Ce===void 0&&(w.addEventListener("dispose",mt),Ce=new Map,F.programs=Ce,F.programVariants=new Map);let tt=Ce.get(be);if(tt!==void 0){if(F.currentProgram===tt&&F.lightsStateVersion===Se)return km(w,ue),tt}else ue.uniforms=Q.getUniforms(w),O!==null&&w.isNodeMaterial&&O.build(w,W,ue),w.onBeforeCompile(ue,P),tt=Q.acquireProgram(ue,be),Ce.set(be,tt),F.uniforms=ue.uniforms;let Ee=F.uniforms;return(!w.isShaderMaterial&&!w.isRawShaderMaterial||w.clipping===!0)&&(Ee.clippingPlanes=j.uniform),km(w,ue),F.needsLights=nb(w),F.lightsStateVersion=Se,F.needsLights&&(Ee.ambientLightColor.value=V.state.ambient,Ee.lightProbe.value=V.state.probe,Ee.sunLights.value=V.state.sun,Ee.sunLightShadows.value=V.state.sunShadow,Ee.directionalLights.value=V.state.directional,Ee.directionalLightShadows.value=V.state.directionalShadow,Ee.spotLights.value=V.state.spot,Ee.spotLightShadows.value=V.state.spotShadow,Ee.rectAreaLights.value=V.state.rectArea,Ee.ltc_1.value=V.state.rectAreaLTC1,Ee.ltc_2.value=V.state.rectAreaLTC2,Ee.pointLights.value=V.state.point,Ee.pointLightShadows.value=V.state.pointShadow,Ee.hemisphereLights.value=V.state.hemi,Ee.sunShadowMatrix.value=V.state.sunShadowMatrix,Ee.sunShadowCascade.value=V.state.sunShadowCascade,Ee.directionalShadowMatrix.value=V.state.directionalShadowMatrix,Ee.spotLightMatrix.value=V.state.spotLightMatrix,Ee.spotLightMap.value=V.state.spotLightMap,Ee.pointShadowMatrix.value=V.state.pointShadowMatrix),F.numLightProbeGrids=Dm(R.state.lightProbeGridArray),F.currentProgram=tt,F.uniformsList=null,tt}function Qv(w,N,W,F,V){let fe=Ue.get(w),Se=fe.currentProgram.id+","+F+","+V,ue=fe.programVariants.get(Se);return ue===void 0?(ue=Co(w,N,W),fe.programVariants.set(Se,ue)):(fe.currentProgram=ue,fe.uniformsList=null,fe.outputColorSpace=F,fe.toneMapping=V),ue}function Nm(w){if(w.uniformsList===null){let N=w.currentProgram.getUniforms();w.uniformsList=eo.seqWithValue(N.seq,w.uniforms)}return w.uniformsList}function km(w,N){let W=Ue.get(w);W.outputColorSpace=N.outputColorSpace,W.batching=N.batching,W.batchingColor=N.batchingColor,W.instancing=N.instancing,W.instancingColor=N.instancingColor,W.instancingMorph=N.instancingMorph,W.skinning=N.skinning,W.morphTargets=N.morphTargets,W.morphNormals=N.morphNormals,W.morphColors=N.morphColors,W.morphTargetsCount=N.morphTargetsCount,W.numClippingPlanes=N.numClippingPlanes,W.numIntersection=N.numClipIntersection,W.vertexAlphas=N.vertexAlphas,W.vertexTangents=N.vertexTangents,W.toneMapping=N.toneMapping}function eb(w,N,W,F,V){N.isScene!==!0&&(N=Bn),$e.resetTextureUnits();let fe=N.fog,Se=F.isMeshStandardMaterial||F.isMeshLambertMaterial||F.isMeshPhongMaterial?N.environment:null,ue=ne===null?P.outputColorSpace:ne.isXRRenderTarget===!0?ne.texture.colorSpace:it.workingColorSpace,be=F.isMeshStandardMaterial||F.isMeshLambertMaterial&&!F.envMap||F.isMeshPhongMaterial&&!F.envMap,Ce=C.get(F.envMap||Se,be),qe=F.vertexColors===!0&&!!W.attributes.color&&W.attributes.color.itemSize===4,tt=!!W.attributes.tangent&&(!!F.normalMap||F.anisotropy>0),Ee=!!W.morphAttributes.position,nt=!!W.morphAttributes.normal,Pt=!!W.morphAttributes.color,vt=pi;F.toneMapped&&(ne===null||ne.isXRRenderTarget===!0)&&(vt=P.toneMapping);let yt=W.morphAttributes.position||W.morphAttributes.normal||W.morphAttributes.color,nn=yt!==void 0?yt.length:0,Ae=Ue.get(F),dn=R.state.lights;if(Lt===!0&&(_n===!0||w!==J)){let St=w===J&&F.id===$;j.setState(F,w,St)}let at=!1,Es=!1;F.version===Ae.__version?Ae.needsLights&&Ae.lightsStateVersion!==dn.state.version||V.isBatchedMesh&&Ae.batching===!1||!V.isBatchedMesh&&Ae.batching===!0||V.isBatchedMesh&&Ae.batchingColor===!0&&V._colorsTexture===null||V.isBatchedMesh&&Ae.batchingColor===!1&&V._colorsTexture!==null||V.isInstancedMesh&&Ae.instancing===!1||!V.isInstancedMesh&&Ae.instancing===!0||V.isSkinnedMesh&&Ae.skinning===!1||!V.isSkinnedMesh&&Ae.skinning===!0||V.isInstancedMesh&&Ae.instancingColor===!0&&V.instanceColor===null||V.isInstancedMesh&&Ae.instancingColor===!1&&V.instanceColor!==null||V.isInstancedMesh&&Ae.instancingMorph===!0&&V.morphTexture===null||V.isInstancedMesh&&Ae.instancingMorph===!1&&V.morphTexture!==null||Ae.envMap!==Ce||F.fog===!0&&Ae.fog!==fe||Ae.numClippingPlanes!==void 0&&(Ae.numClippingPlanes!==j.numPlanes||Ae.numIntersection!==j.numIntersection)||Ae.vertexAlphas!==qe||Ae.vertexTangents!==tt||Ae.morphTargets!==Ee||Ae.morphNormals!==nt||Ae.morphColors!==Pt||Ae.morphTargetsCount!==nn||Ae.numLightProbeGrids!==Dm(R.state.lightProbeGridArray)?at=!0:(Ae.outputColorSpace!==ue||Ae.toneMapping!==vt)&&(Es=!0):(at=!0,Ae.__version=F.version);let sn=Ae.currentProgram;(at===!0||Es===!0)&&(sn=Es===!0?Qv(F,N,V,ue,vt):Co(F,N,V),O&&F.isNodeMaterial&&O.onUpdateProgram(F,sn,Ae));let Al=!1,qi=!1,As=!1,rt=sn.getUniforms(),Yt=Ae.uniforms;if(me.useProgram(sn.program)&&(Al=!0,qi=!0,As=!0),F.id!==$&&($=F.id,qi=!0),Al||J!==w){me.buffers.depth.getReversed()&&w.reversedDepth!==!0&&(w._reversedDepth=!0,w.updateProjectionMatrix()),rt.setValue(U,"projectionMatrix",w.projectionMatrix),rt.setValue(U,"viewMatrix",w.matrixWorldInverse);let Vt=rt.map.cameraPosition;Vt!==void 0&&Vt.setValue(U,oi.setFromMatrixPosition(w.matrixWorld)),wt.logarithmicDepthBuffer&&rt.setValue(U,"logDepthBufFC",2/(Math.log(w.far+1)/Math.LN2)),(F.isMeshPhongMaterial||F.isMeshToonMaterial||F.isMeshLambertMaterial||F.isMeshBasicMaterial||F.isMeshStandardMaterial||F.isShaderMaterial)&&rt.setValue(U,"isOrthographic",w.isOrthographicCamera===!0),J!==w&&(J=w,qi=!0,As=!0)}if(Ae.needsLights&&(dn.state.sunShadowMap.length>0&&rt.setValue(U,"sunShadowMap",dn.state.sunShadowMap,$e),dn.state.directionalShadowMap.length>0&&rt.setValue(U,"directionalShadowMap",dn.state.directionalShadowMap,$e),dn.state.spotShadowMap.length>0&&rt.setValue(U,"spotShadowMap",dn.state.spotShadowMap,$e),dn.state.pointShadowMap.length>0&&rt.setValue(U,"pointShadowMap",dn.state.pointShadowMap,$e)),V.isSkinnedMesh){rt.setOptional(U,V,"bindMatrix"),rt.setOptional(U,V,"bindMatrixInverse");let St=V.skeleton;St&&(St.boneTexture===null&&St.computeBoneTexture(),rt.setValue(U,"boneTexture",St.boneTexture,$e))}V.isBatchedMesh&&(rt.setOptional(U,V,"batchingTexture"),rt.setValue(U,"batchingTexture",V._matricesTexture,$e),rt.setOptional(U,V,"batchingIdTexture"),rt.setValue(U,"batchingIdTexture",V._indirectTexture,$e),rt.setOptional(U,V,"batchingColorTexture"),V._colorsTexture!==null&&rt.setValue(U,"batchingColorTexture",V._colorsTexture,$e));let Zn=W.morphAttributes;if((Zn.position!==void 0||Zn.normal!==void 0||Zn.color!==void 0)&&K.update(V,W,sn),(qi||Ae.receiveShadow!==V.receiveShadow)&&(Ae.receiveShadow=V.receiveShadow,rt.setValue(U,"receiveShadow",V.receiveShadow)),(F.isMeshStandardMaterial||F.isMeshLambertMaterial||F.isMeshPhongMaterial)&&F.envMap===null&&N.environment!==null&&(Yt.envMapIntensity.value=N.environmentIntensity),Yt.dfgLUT!==void 0&&(Yt.dfgLUT.value=xT()),qi){if(rt.setValue(U,"toneMappingExposure",P.toneMappingExposure),Ae.needsLights&&tb(Yt,As),fe&&F.fog===!0&&ae.refreshFogUniforms(Yt,fe),ae.refreshMaterialUniforms(Yt,F,ve,Oe,R.state.transmissionRenderTarget[w.id]),Ae.needsLights&&Ae.numLightProbeGrids>0){let St=b,Vt=0;for(let wi of R.state.lightProbeGridArray)wi.texture!==null&&(St.textures[Vt]=wi.texture,St.min[Vt]=wi.boundingBox.min,St.max[Vt]=wi.boundingBox.max,St.resolution[Vt]=wi.resolution,Vt++);for(let wi in St)St[wi].length=Vt;Yt.probesSH.value=St.textures,Yt.probesMin.value=St.min,Yt.probesMax.value=St.max,Yt.probesResolution.value=St.resolution}eo.upload(U,Nm(Ae),Yt,$e)}if(F.isShaderMaterial&&F.uniformsNeedUpdate===!0&&(eo.upload(U,Nm(Ae),Yt,$e),F.uniformsNeedUpdate=!1),F.isSpriteMaterial&&rt.setValue(U,"center",V.center),rt.setValue(U,"modelViewMatrix",V.modelViewMatrix),rt.setValue(U,"normalMatrix",V.normalMatrix),rt.setValue(U,"modelMatrix",V.matrixWorld),F.uniformsGroups!==void 0){let St=F.uniformsGroups;for(let Vt=0,wi=St.length;Vt<wi;Vt++){let Um=St[Vt];Pe.update(Um,sn),Pe.bind(Um,sn)}}return sn}function tb(w,N){w.ambientLightColor.needsUpdate=N,w.lightProbe.needsUpdate=N,w.sunLights.needsUpdate=N,w.sunLightShadows.needsUpdate=N,w.directionalLights.needsUpdate=N,w.directionalLightShadows.needsUpdate=N,w.pointLights.needsUpdate=N,w.pointLightShadows.needsUpdate=N,w.spotLights.needsUpdate=N,w.spotLightShadows.needsUpdate=N,w.rectAreaLights.needsUpdate=N,w.hemisphereLights.needsUpdate=N}function nb(w){return w.isMeshLambertMaterial||w.isMeshToonMaterial||w.isMeshPhongMaterial||w.isMeshStandardMaterial||w.isShadowMaterial||w.isShaderMaterial&&w.lights===!0}this.getActiveCubeFace=function(){return X},this.getActiveMipmapLevel=function(){return G},this.getRenderTarget=function(){return ne},this.setRenderTargetTextures=function(w,N,W){let F=Ue.get(w);F.__autoAllocateDepthBuffer=w.resolveDepthBuffer===!1,F.__autoAllocateDepthBuffer===!1&&(F.__useRenderToTexture=!1),Ue.get(w.texture).__webglTexture=N,Ue.get(w.depthTexture).__webglTexture=F.__autoAllocateDepthBuffer?void 0:W,F.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(w,N){let W=Ue.get(w);W.__webglFramebuffer=N,W.__useDefaultFramebuffer=N===void 0},this.setRenderTarget=function(w,N=0,W=0){ne=w,X=N,G=W;let F=null,V=!1,fe=!1;if(w){let ue=Ue.get(w);if(ue.__useDefaultFramebuffer!==void 0){me.bindFramebuffer(U.FRAMEBUFFER,ue.__webglFramebuffer),ee.copy(w.viewport),we.copy(w.scissor),ke=w.scissorTest,me.viewport(ee),me.scissor(we),me.setScissorTest(ke),$=-1;return}else if(ue.__webglFramebuffer===void 0)$e.setupRenderTarget(w);else if(ue.__hasExternalTextures)$e.rebindTextures(w,Ue.get(w.texture).__webglTexture,Ue.get(w.depthTexture).__webglTexture);else if(w.depthBuffer){let qe=w.depthTexture;if(ue.__boundDepthTexture!==qe){if(qe!==null&&Ue.has(qe)&&(w.width!==qe.image.width||w.height!==qe.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");$e.setupDepthRenderbuffer(w)}}let be=w.texture;(be.isData3DTexture||be.isDataArrayTexture||be.isCompressedArrayTexture)&&(fe=!0);let Ce=Ue.get(w).__webglFramebuffer;w.isWebGLCubeRenderTarget?(Array.isArray(Ce[N])?F=Ce[N][W]:F=Ce[N],V=!0):w.samples>0&&$e.useMultisampledRTT(w)===!1?F=Ue.get(w).__webglMultisampledFramebuffer:Array.isArray(Ce)?F=Ce[W]:F=Ce,ee.copy(w.viewport),we.copy(w.scissor),ke=w.scissorTest}else ee.copy(Fe).multiplyScalar(ve).floor(),we.copy(pt).multiplyScalar(ve).floor(),ke=xt;if(W!==0&&(F=z),me.bindFramebuffer(U.FRAMEBUFFER,F)&&me.drawBuffers(w,F),me.viewport(ee),me.scissor(we),me.setScissorTest(ke),V){let ue=Ue.get(w.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_CUBE_MAP_POSITIVE_X+N,ue.__webglTexture,W)}else if(fe){let ue=N;for(let be=0;be<w.textures.length;be++){let Ce=Ue.get(w.textures[be]);U.framebufferTextureLayer(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0+be,Ce.__webglTexture,W,ue)}}else if(w!==null&&W!==0){let ue=Ue.get(w.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,ue.__webglTexture,W)}$=-1};function Om(w){let N=Ue.get(w);return(N.__readFormat!==w.format||N.__readType!==w.type)&&(N.__readFormat=w.format,N.__readType=w.type,N.__formatReadable=wt.textureFormatReadable(w.format),N.__typeReadable=wt.textureTypeReadable(w.type)),N}this.readRenderTargetPixels=function(w,N,W,F,V,fe,Se,ue=0){if(!(w&&w.isWebGLRenderTarget)){Ve("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let be=Ue.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Se!==void 0&&(be=be[Se],Array.isArray(be)&&(be=be[0])),be){me.bindFramebuffer(U.FRAMEBUFFER,be);try{let Ce=w.textures[ue],qe=Ce.format,tt=Ce.type;w.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+ue);let Ee=Om(Ce);if(Ee.__formatReadable===!1){Ve("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Ee.__typeReadable===!1){Ve("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}N>=0&&N<=w.width-F&&W>=0&&W<=w.height-V&&U.readPixels(N,W,F,V,oe.convert(qe),oe.convert(tt),fe)}finally{let Ce=ne!==null?Ue.get(ne).__webglFramebuffer:null;me.bindFramebuffer(U.FRAMEBUFFER,Ce)}}},this.readRenderTargetPixelsAsync=async function(w,N,W,F,V,fe,Se,ue=0){if(!(w&&w.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let be=Ue.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Se!==void 0&&(be=be[Se],Array.isArray(be)&&(be=be[0])),be)if(N>=0&&N<=w.width-F&&W>=0&&W<=w.height-V){me.bindFramebuffer(U.FRAMEBUFFER,be);let Ce=w.textures[ue],qe=Ce.format,tt=Ce.type;w.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+ue);let Ee=Om(Ce);if(Ee.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Ee.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let nt=U.createBuffer();U.bindBuffer(U.PIXEL_PACK_BUFFER,nt),U.bufferData(U.PIXEL_PACK_BUFFER,fe.byteLength,U.STREAM_READ),U.readPixels(N,W,F,V,oe.convert(qe),oe.convert(tt),0),U.bindBuffer(U.PIXEL_PACK_BUFFER,null);let Pt=ne!==null?Ue.get(ne).__webglFramebuffer:null;me.bindFramebuffer(U.FRAMEBUFFER,Pt);let vt=U.fenceSync(U.SYNC_GPU_COMMANDS_COMPLETE,0);return U.flush(),await f0(U,vt,4),U.bindBuffer(U.PIXEL_PACK_BUFFER,nt),U.getBufferSubData(U.PIXEL_PACK_BUFFER,0,fe),U.bindBuffer(U.PIXEL_PACK_BUFFER,null),U.deleteBuffer(nt),U.deleteSync(vt),fe}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(w,N=null,W=0){let F=Math.pow(2,-W),V=Math.floor(w.image.width*F),fe=Math.floor(w.image.height*F),Se=N!==null?N.x:0,ue=N!==null?N.y:0;$e.setTexture2D(w,0),U.copyTexSubImage2D(U.TEXTURE_2D,W,0,0,Se,ue,V,fe),me.unbindTexture()},this.copyTextureToTexture=function(w,N,W=null,F=null,V=0,fe=0){let Se,ue,be,Ce,qe,tt,Ee,nt,Pt,vt=w.isCompressedTexture?w.mipmaps[fe]:w.image;if(W!==null)Se=W.max.x-W.min.x,ue=W.max.y-W.min.y,be=W.isBox3?W.max.z-W.min.z:1,Ce=W.min.x,qe=W.min.y,tt=W.isBox3?W.min.z:0;else{let rt=Math.pow(2,-V);Se=Math.floor(vt.width*rt),ue=Math.floor(vt.height*rt),w.isDataArrayTexture?be=vt.depth:w.isData3DTexture?be=Math.floor(vt.depth*rt):be=1,Ce=0,qe=0,tt=0}F!==null?(Ee=F.x,nt=F.y,Pt=F.z):(Ee=0,nt=0,Pt=0);let yt=oe.convert(N.format),nn=oe.convert(N.type),Ae;N.isData3DTexture?($e.setTexture3D(N,0),Ae=U.TEXTURE_3D):N.isDataArrayTexture||N.isCompressedArrayTexture?($e.setTexture2DArray(N,0),Ae=U.TEXTURE_2D_ARRAY):($e.setTexture2D(N,0),Ae=U.TEXTURE_2D),me.activeTexture(U.TEXTURE0),me.pixelStorei(U.UNPACK_FLIP_Y_WEBGL,N.flipY),me.pixelStorei(U.UNPACK_PREMULTIPLY_ALPHA_WEBGL,N.premultiplyAlpha),me.pixelStorei(U.UNPACK_ALIGNMENT,N.unpackAlignment);let dn=me.getParameter(U.UNPACK_ROW_LENGTH),at=me.getParameter(U.UNPACK_IMAGE_HEIGHT),Es=me.getParameter(U.UNPACK_SKIP_PIXELS),sn=me.getParameter(U.UNPACK_SKIP_ROWS),Al=me.getParameter(U.UNPACK_SKIP_IMAGES);me.pixelStorei(U.UNPACK_ROW_LENGTH,vt.width),me.pixelStorei(U.UNPACK_IMAGE_HEIGHT,vt.height),me.pixelStorei(U.UNPACK_SKIP_PIXELS,Ce),me.pixelStorei(U.UNPACK_SKIP_ROWS,qe),me.pixelStorei(U.UNPACK_SKIP_IMAGES,tt);let qi=w.isDataArrayTexture||w.isData3DTexture,As=N.isDataArrayTexture||N.isData3DTexture;if(w.isDepthTexture){let rt=Ue.get(w),Yt=Ue.get(N),Zn=Ue.get(rt.__renderTarget),St=Ue.get(Yt.__renderTarget);me.bindFramebuffer(U.READ_FRAMEBUFFER,Zn.__webglFramebuffer),me.bindFramebuffer(U.DRAW_FRAMEBUFFER,St.__webglFramebuffer);for(let Vt=0;Vt<be;Vt++)qi&&(U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,Ue.get(w).__webglTexture,V,tt+Vt),U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,Ue.get(N).__webglTexture,fe,Pt+Vt)),U.blitFramebuffer(Ce,qe,Ce+Se,qe+ue,Ee,nt,Ee+Se,nt+ue,U.DEPTH_BUFFER_BIT,U.NEAREST);me.bindFramebuffer(U.READ_FRAMEBUFFER,null),me.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else if(V!==0||w.isRenderTargetTexture||Ue.has(w)){let rt=Ue.get(w),Yt=Ue.get(N);me.bindFramebuffer(U.READ_FRAMEBUFFER,I),me.bindFramebuffer(U.DRAW_FRAMEBUFFER,H);for(let Zn=0;Zn<be;Zn++)qi?U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,rt.__webglTexture,V,tt+Zn):U.framebufferTexture2D(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,rt.__webglTexture,V),As?U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,Yt.__webglTexture,fe,Pt+Zn):U.framebufferTexture2D(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,Yt.__webglTexture,fe),V!==0?U.blitFramebuffer(Ce,qe,Ce+Se,qe+ue,Ee,nt,Ee+Se,nt+ue,U.COLOR_BUFFER_BIT,U.NEAREST):As?U.copyTexSubImage3D(Ae,fe,Ee,nt,Pt+Zn,Ce,qe,Se,ue):U.copyTexSubImage2D(Ae,fe,Ee,nt,Ce,qe,Se,ue);me.bindFramebuffer(U.READ_FRAMEBUFFER,null),me.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else As?w.isDataTexture||w.isData3DTexture?U.texSubImage3D(Ae,fe,Ee,nt,Pt,Se,ue,be,yt,nn,vt.data):N.isCompressedArrayTexture?U.compressedTexSubImage3D(Ae,fe,Ee,nt,Pt,Se,ue,be,yt,vt.data):U.texSubImage3D(Ae,fe,Ee,nt,Pt,Se,ue,be,yt,nn,vt):w.isDataTexture?U.texSubImage2D(U.TEXTURE_2D,fe,Ee,nt,Se,ue,yt,nn,vt.data):w.isCompressedTexture?U.compressedTexSubImage2D(U.TEXTURE_2D,fe,Ee,nt,vt.width,vt.height,yt,vt.data):U.texSubImage2D(U.TEXTURE_2D,fe,Ee,nt,Se,ue,yt,nn,vt);me.pixelStorei(U.UNPACK_ROW_LENGTH,dn),me.pixelStorei(U.UNPACK_IMAGE_HEIGHT,at),me.pixelStorei(U.UNPACK_SKIP_PIXELS,Es),me.pixelStorei(U.UNPACK_SKIP_ROWS,sn),me.pixelStorei(U.UNPACK_SKIP_IMAGES,Al),fe===0&&N.generateMipmaps===!0&&N.mipmapsAutoUpdate===!0&&U.generateMipmap(Ae),me.unbindTexture()},this.initRenderTarget=function(w){Ue.get(w).__webglFramebuffer===void 0&&$e.setupRenderTarget(w)},this.initTexture=function(w){w.isCubeTexture?$e.setTextureCube(w,0):w.isData3DTexture?$e.setTexture3D(w,0):w.isDataArrayTexture||w.isCompressedArrayTexture?$e.setTexture2DArray(w,0):$e.setTexture2D(w,0),me.unbindTexture()},this.resetState=function(){X=0,G=0,ne=null,me.reset(),le.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Wn}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=it._getDrawingBufferColorSpace(e),t.unpackColorSpace=it._getUnpackColorSpace()}};var yT=.1,tx=2,vT=1,bT=2,_T=.3,$h=3,tp=.03,Xh=class{list=[];taken=0;first=0;extend(e,t){for(;this.taken<e.length;this.taken++){let n=this.taken;t(n)?n-this.first+1===$h?this.list.push([e[this.first],e[n]]):n-this.first>=$h&&(this.list.at(-1)[1]=e[n]):this.first=n+1}return this.list}},Ys="push or collision",ja=i=>i.replace(/(?<!or )\b(?:human )?collision(s?)\b/i,(e,t,n)=>t?"pushes or collisions":n?Ys:Yi(Ys)),Ka=({kind:i,by_hand:e})=>/guiding/i.test(i)?"hand guiding":e||/collision/i.test(i)?Ys:null,qh=class{constructor(e,t){this.plan=e;this.number=e.round,this.q=Array.from({length:t},()=>[]),this.particles=zm(e.particles),this.treated=e.treatment?Vm(e.treatment):null}plan;number;start=0;t=[];q;tool=[];force=[];normal=new Po;height=new Po;particles;treated;interpreted=null;truth=null;observed=null;over=!1;states=null;get target(){let{press_force:e=null}=this.plan;return e!==null&&e>0?e:null}get events(){return this.interpreted?.events??this.plan.events??[]}get count(){return this.t.length}get length(){let e=this.t.at(-1)??0;return this.interpreted?Math.max(this.interpreted.duration,e):this.over&&this.count?e:Math.max(this.plan.duration,e)}get end(){return this.start+this.length}push({t:e,q:t,tool:n,force:s,normal:r,height:o}){let a=e.length;if(n.length!==7*a||s.length!==3*a||r.length!==a||o.length!==a||Object.values(t).some(c=>c.length!==a))throw new Error("columns of samples differ in length");if(!e.every(Number.isFinite))throw new Error("a time is not finite");for(let c of e)this.t.push(Math.max(ci(c),this.t.at(-1)??-1/0));this.q.forEach((c,h)=>{let u=t[h],d=c.at(-1)??0;for(let f=0;f<a;f++)c.push(u?ci(u[f]):d)});for(let[c,h]of[[this.tool,n],[this.force,s],[this.normal,r],[this.height,o]])for(let u of h)c.push(ci(u))}place(e){let t=Math.max(0,li(this.t,e)),[n,s]=[this.t[t],this.t[t+1]];return t+1>=this.count||!(s>n)?[t,0]:[t,Math.min(1,Math.max(0,(e-n)/(s-n)))]}positions(e,t){if(!this.count)return t;let[n,s]=this.place(e);return this.q.forEach((r,o)=>{t[o]=Za(r[n],r[n+1],s)}),t}toolAt(e){if(!this.count)return null;let[t,n]=this.place(e);return wT(this.tool,t,n)}forceAt(e){if(!this.count)return null;let[t,n]=this.place(e),s=r=>Za(this.force[3*t+r],this.force[3*t+3+r],n);return[s(0),s(1),s(2)]}valueAt({data:e},t){if(!this.count)return null;let[n,s]=this.place(t),r=Za(e[n],e[n+1],s);return Number.isFinite(r)?r:null}get firstContact(){return this.plan.phases.find(({contact:e})=>e)?.start??0}growthAt(e){let{growth:t}=this.plan;if(!t.length)return null;let n=t.length-1;for(;n>0&&t[n][0]>e;)n--;let[s,r]=[t[n],t[n+1]];return!r||e<=s[0]||r[0]<=s[0]?s[1]:Za(s[1],r[1],Math.min(1,(e-s[0])/(r[0]-s[0])))}phaseAt(e){let{phases:t}=this.plan,n=-1;return t.forEach((s,r)=>{s.start<=e+1e-9&&(n=r)}),n}get contacts(){let{basis:e,count:t}=this;return this.states?.basis!==e&&(this.states={basis:e,count:-1,pressed:new Xh,high:new Xh,contact:[],pushed:[]}),this.states.count!==t&&Object.assign(this.states,this.classify(this.states),{count:t}),this.states}contactAt(e){let{contact:t,pushed:n}=this.contacts;return ep(n,e)?"pushed":ep(t,e)?"contact":"none"}isPressed(e){return ep(this.contacts.contact,e)}get basis(){return`${!!this.interpreted} ${this.touchForce}`}get touchForce(){return yT*tx*Math.floor(Math.max(0,this.normal.largest)/tx)}classify({pressed:e,high:t}){let{normal:n,height:s,plan:r,interpreted:o}=this,a=n.least<=n.largest,l=this.touchForce,c=Math.max(_T,.5*l),h=o?.contacts??r.contacts,u=this.events.filter(Ka).map(({start:m,end:y})=>[m,y]);if(!this.count||!a){let m=r.phases.filter(({contact:y})=>y).map(({start:y,end:S})=>[y,S]);return{contact:Wh(h??m),pushed:Wh(u)}}let d=m=>s.data[m]>tp,f=m=>Math.hypot(this.force[3*m],this.force[3*m+1],this.force[3*m+2]),p=t.extend(this.t,m=>d(m)&&f(m)>Math.max(bT,l)),x=u.length?Wh([...u,...p]):p;if(!h)return{contact:e.extend(this.t,m=>!d(m)&&n.data[m]>Math.max(vT,l)),pushed:x};let g=([m,y])=>(n.range(this.place(m)[0],this.place(y)[0]+2)?.[1]??0)>c;return{contact:Wh(o?.incidents?h:h.filter(g)),pushed:x}}};function ep(i,e){let t=Io(i.length,n=>i[n][0]<=e);return t>=0&&e<=i[t][1]}function Wh(i){let e=[];for(let[t,n]of[...i].sort((s,r)=>s[0]-r[0])){let s=e.at(-1);s&&t<=s[1]?s[1]=Math.max(s[1],n):e.push([t,n])}return e}var Za=(i,e,t)=>t>0?i+t*(e-i):i;function wT(i,e,t){let[n,s]=[7*e,7*e+7],r=i.slice(n,s);if(t<=0)return r;for(let o=0;o<3;o++)r[o]=Za(r[o],i[s+o],t);return Rt.slerpFlat(r,3,i,n+3,i,s+3,t),r}var gt=i=>typeof i=="string",ye=i=>typeof i=="number"&&Number.isFinite(i),Xe=i=>e=>Array.isArray(e)&&e.every(i),us=i=>Array.isArray(i),Zh=(...i)=>e=>Array.isArray(e)&&e.length===i.length&&i.every((t,n)=>t(e[n])),Zs=i=>Zh(...Array.from({length:i},()=>ye)),Ye=i=>e=>e==null||i(e),ht=i=>e=>typeof e=="object"&&e!==null&&Object.entries(i).every(([t,n])=>n(e[t])),ds=(i,e)=>t=>ht(i)(t)&&e(t),no=Zs(7),Ja=Zs(2),nx=ht({mean:ye,low:ye,high:ye}),MT=new Map([["box",ht({size:Zs(3)})],["sphere",ht({radius:ye})],["mesh",ht({mesh:ye})],["cylinder",ht({radius:ye,length:ye})],["capsule",ht({radius:ye,length:ye})]]),Yh=ds({pose:no,kind:gt,color:Ye(Zs(4))},i=>MT.get(i.kind)?.(i)===!0),ix=ht({vertices:Xe(ye),triangles:Xe(ye)}),ST=ds({radius_m:ye,axis_rad:ye},({kind:i,radius_m:e})=>i==="cylinder"&&e!==0),TT=ds({radius_m:ye,half_angle_rad:ye,axis_rad:ye},({kind:i,radius_m:e,half_angle_rad:t})=>i==="cone"&&e!==0&&t>0&&t<Math.PI/2),ET=ds({points:Xe(ye),places:Xe(ye),triangles:Xe(ye)},({kind:i,points:e,places:t,triangles:n})=>{let s=e.length/3,r=o=>Number.isInteger(o)&&o>=0&&o<s;return i==="mesh"&&s>0&&t.length===2*s&&n.length>0&&n.length%3===0&&n.every(r)}),sx=i=>ST(i)||TT(i)||ET(i),AT=i=>sx(i)||ds({},({kind:e})=>e==="plane")(i),rx=ht({kind:gt,start:ye,end:ye,words:gt}),RT=ht({task:Ye(ht({target:ye})),tool:ht({solid:Yh}),meshes:Xe(ix),robot:Ye(ht({variables:Xe(gt),links:Xe(ht({shapes:Xe(Yh),collision:Ye(Xe(Yh))})),joints:Xe(ht({parent:ye,pose:no,axis:Zs(3),offset:ye,terms:Xe(Ja)}))}))}),CT=ht({strategy:gt,chosen:i=>typeof i=="boolean",error:Ye(gt),score:Ye(ye),predicted:Ye(ye),lost:Ye(ye),strokes:Ye(ye),in_contact:Ye(ye),duration:Ye(ye),lines:Ye(Xe(Xe(ye)))}),PT={why:Xe(gt),considered:Ye(Xe(CT)),lost:Ye(ye),headings:Ye(Xe(gt)),without:Ye(Xe(ht({stroke:ye,performance:ye,lost:ye,particles:Xe(ye),treated:Ye(us)}))),another:Ye(ht({gain:ye,line:Xe(ye),way:ye})),bases:Ye(ht({poses:Xe(Zh(ye,ye,ye,Ye(ye))),chosen:Xe(ye)}))},IT=1e6,LT=ds({unit:gt,target:ye,low:ye,high:ye,step:ye,cell:Zs(2),places:Xe(ye),steps:Xe(Zh(ye,Xe(ye),Xe(ye)))},({unit:i,low:e,high:t,target:n,places:s})=>(i==="passes"?[n,e,t].every(Number.isInteger):i==="\xB5m"&&e<t)&&t<=IT&&e>0&&e<=n&&n<=t&&s.length%2===0),DT=ht({...PT,round:ye,duration:ye,root:Ye(no),surface:ht({pose:no,rings:Xe(Xe(ye)),shape:Ye(sx)}),scene:Xe(Yh),meshes:Xe(ix),goal:Ye(ds({kind:gt},i=>i.kind!=="collected"||ht({place:Zs(2),radius:ye})(i))),strokes:Xe(Xe(ye)),phases:Xe(ht({name:gt,start:ye,end:ye})),press_force:Ye(ye),predicted:Ye(ye),growth:Xe(Ja),particles:Xe(Zh(ye,us,us)),treatment:Ye(LT),events:Ye(Xe(rx)),contacts:Ye(Xe(Ja))}),NT=ht({time:Ye(ye),title:gt,evidence:gt,effect:gt,advice:gt}),kT=ds({cell:ye,places:Xe(ye),expected:Xe(ye),goal:Ye(ye)},({cell:i,places:e,expected:t})=>i>0&&e.length===2*t.length),OT=ht({round:ye,duration:ye,estimate:nx,by_touch:nx,verdict:gt,words:Xe(gt),found:Ye(no),events:Xe(rx),contacts:Xe(Ja),incidents:Ye(Xe(NT)),particles:us,density:Ye(kT),treated:Ye(us)}),UT=i=>Array.isArray(i)&&gt(i[0])&&gt(i[1])&&Ye(ye)(i[2]),FT={head:RT,round:DT,interpreted:OT,stage:ht({stage:gt,words:gt}),observed:ht({round:ye,detections:us}),truth:ht({round:ye,performance:Ye(ye),particles:Ye(us),treated:Ye(us),pushes:Xe(Ja),surface:Ye(no),shape:Ye(AT)}),ended:ht({verdict:Ye(gt),badge:Ye(gt),story:ht({asked:gt,happened:gt,sure:gt,surer:gt,next:Ye(ht({words:gt,command:Ye(gt)}))}),facts:Xe(UT)})};function ox(i){let e=i;if(e?.piece==="judged"){let{felt:t,...n}=e;return{by_touch:t,...n,piece:"interpreted"}}if(e?.piece==="round"&&Array.isArray(e.considered)){let t=e.considered.map(n=>n&&"worth"in n?{score:n.worth,...n}:n);return{...e,considered:t}}return i}function ax(i){if(typeof i!="object"||i===null)throw new Error("a line is not a piece");let e=FT[i.piece];if(e&&!e(i))throw new Error(`a ${i.piece} piece lacks a field`);i.piece==="head"&&BT(i)}function BT({robot:i,tool:e}){if(!i)return;let t=i.joints.length+1;if(i.links.length>t||i.joints.some(({parent:n},s)=>!(n>=0&&n<=s)))throw new Error("a joint comes before its parent, or a link has no joint");if(e.link!==null&&!(e.link<t))throw new Error("the link of the tool does not exist")}var jh=.001;function Qa(i,e){let t=i?.shape??e;return t&&t.kind!=="plane"?t:null}var gi=class i{head=null;rounds=[];stages=[];meshes=[];before={observed:null,truth:null};ended=null;broken=0;unknown=0;version=0;closed=!1;callbacks=new Set;cachedHappenings=null;static parse(e){let t=new i;for(let n of e.split(`
`))t.applyLine(n);return t.close(),t}applyLine(e){if(!e.trim())return;let t;try{t=JSON.parse(e)}catch{this.broken++,this.notify(null);return}this.apply(t)}apply(e){try{this.add(e)}catch{this.broken++}this.notify(e)}close(){this.closed=!0;for(let e of this.rounds)e.over=!0;this.layOutRounds(),this.notify(null)}get live(){return!this.closed&&!this.ended}onChange(e){return this.callbacks.add(e),()=>this.callbacks.delete(e)}notify(e){this.version++;for(let t of this.callbacks)t(e)}add(e){let t=ox(e);switch(ax(t),t.piece){case"head":this.meshes.push(...t.meshes),this.head=t;break;case"stage":this.stages.push(t);break;case"round":{let n=new qh(t,this.head?.robot?.variables.length??0);this.meshes.push(...t.meshes);let s=this.rounds.at(-1);s&&s.number===n.number&&!s.count&&!s.interpreted?this.rounds.pop():s&&(s.over=!0),this.rounds.push(n),this.layOutRounds();break}case"samples":{let n=this.round(t.round);n.push(t),n!==this.rounds.at(-1)&&this.layOutRounds();break}case"observed":this.placeOf(t).observed=t;break;case"interpreted":this.round(t.round).interpreted={...t},this.layOutRounds();break;case"truth":this.placeOf(t).truth=t;break;case"ended":this.ended=t;for(let n of this.rounds)n.over=!0;this.layOutRounds();break;default:this.unknown++}}round(e){let t=this.rounds.findLast(n=>n.number===e);if(!t)throw new Error(`no round ${e}`);return t}placeOf({round:e}){return e===0?this.before:this.round(e)}layOutRounds(){let e=0;for(let t of this.rounds)t.start=e,e+=t.length}get duration(){return this.rounds.at(-1)?.end??0}get now(){let e=this.rounds.at(-1);return!e||!this.live||e.interpreted||e.plan.kind==="planned"?this.duration:e.start+(e.count?e.t.at(-1):0)}roundAt(e){return this.rounds[Math.max(0,Io(this.rounds.length,t=>this.rounds[t].start<=e))]??null}at(e){let t=this.roundAt(e);if(!t)return null;let n=Math.min(Math.max(0,e-t.start),t.length),s=t.valueAt(t.normal,n);return{round:t,time:n,normal:s,q:t.count?t.positions(n,new Float64Array(t.q.length)):new Float64Array,tool:t.toolAt(n),force:t.forceAt(n),height:t.valueAt(t.height,n),performance:t.growthAt(n),contact:t.contactAt(n),phase:t.phaseAt(n)}}outcomeAt(e){let t=this.rounds.findLast(l=>l.end<=e+1e-6&&(l.interpreted||l.truth||l.observed)),n=t??this.rounds[0],{truth:s,observed:r}=t??this.before;if(!n||!(t||s||r))return null;let{shape:o}=n.plan.surface,a=t?.interpreted?.found??n.plan.surface.pose;return{since:t?.end??0,pose:a,actualPose:s?.surface??a,shape:o,actualShape:Qa(s,o),estimated:np(t?.interpreted?.particles),actual:np(s?.particles),seen:np(r?.detections)}}endedAt(e){let t=this.rounds.findLastIndex(s=>s.end<=e+1e-6),n=this.rounds[t+1];return n&&e>=n.start+n.firstContact?null:this.rounds[t]??null}resultAt(e){let t=this.endedAt(e);return t?.interpreted?t:null}foundAt(e){return this.rounds.findLast(t=>t.end<=e+1e-6)?.interpreted?.found??null}get happenings(){if(this.cachedHappenings?.version===this.version)return this.cachedHappenings.list;let e=[];for(let{number:t,start:n,events:s,truth:r}of this.rounds){for(let o of s)e.push({start:n+o.start,end:n+o.end,source:"event",round:t,kind:Ka(o)??o.kind,words:o.words});for(let[o,a]of r?.pushes??[])e.push({start:n+o,end:n+a,source:"push",round:t,kind:"true push",words:"A push in the simulated world."})}return e.sort((t,n)=>t.start-n.start),this.cachedHappenings={version:this.version,list:e},e}get stops(){let e=[0,this.duration];for(let{start:t,plan:n}of this.rounds){e.push(t);for(let s of n.phases)s.contact&&e.push(t+s.start)}for(let{start:t}of this.happenings)e.push(t);return[...new Set(e)].filter(t=>t<=this.duration).sort((t,n)=>t-n)}},np=i=>i?lt(i):null;var lx="wisch-theme",cx=()=>document.documentElement,ip=new Set,Qh=!1,sp=null,zT=()=>{try{let i=localStorage.getItem(lx);return i==="light"||i==="dark"?i:null}catch{return null}};function fs(){return Qh?"light":sp??(matchMedia("(prefers-color-scheme: dark)").matches?"dark":"light")}function hx(i){sp=i;try{localStorage.setItem(lx,i)}catch{}Kh()}function io(i){return ip.add(i),()=>ip.delete(i)}function Kh(){cx().dataset.theme=fs(),Jh=null;for(let i of ip)i()}function ux(){sp=zT(),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",Kh);let i=e=>{Qh!==e&&(Qh=e,Kh())};matchMedia("print").addEventListener("change",({matches:e})=>i(e)),addEventListener("beforeprint",()=>i(!0)),addEventListener("afterprint",()=>i(!1)),Kh()}var so=()=>Qh,Jh=null;function Me(i){Jh??=new Map;let e=Jh.get(i);return e===void 0&&(e=getComputedStyle(cx()).getPropertyValue(`--${i}`).trim()||"#888888",Jh.set(i,e)),e}function px(i,e=!1){let t=i[0].index!==null,n=new Set(Object.keys(i[0].attributes)),s=new Set(Object.keys(i[0].morphAttributes)),r={},o={},a=i[0].morphTargetsRelative,l=new We;l.morphTargetsRelative=a;let c=0;for(let h=0;h<i.length;++h){let u=i[h],d=0,f=0;if(t!==(u.index!==null))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". All geometries must have compatible attributes; make sure index attribute exists among all geometries, or in none of them."),null;for(let p in u.attributes){if(!n.has(p))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+'. All geometries must have compatible attributes; make sure "'+p+'" attribute exists among all geometries, or in none of them.'),null;r[p]===void 0&&(r[p]=[]),r[p].push(u.attributes[p]),d++}if(d!==n.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". Make sure all geometries have the same number of attributes."),null;if(a!==u.morphTargetsRelative)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". .morphTargetsRelative must be consistent throughout all geometries."),null;for(let p in u.morphAttributes){if(!s.has(p))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+".  .morphAttributes must be consistent throughout all geometries."),null;if(u.morphAttributes[p].length!==i[0].morphAttributes[p].length)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+'. All geometries must have the same number of morph targets for the "'+p+'" morph attribute.'),null;o[p]===void 0&&(o[p]=[]),o[p].push(u.morphAttributes[p]),f++}if(f!==s.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". Make sure all geometries have the same number of morph attributes."),null;if(e){let p;if(t)p=u.index.count;else if(u.attributes.position!==void 0)p=u.attributes.position.count;else return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+h+". The geometry must have either an index or a position attribute"),null;l.addGroup(c,p,h),c+=p}}if(t){let h=0,u=[];for(let d=0;d<i.length;++d){let f=i[d].index;for(let p=0;p<f.count;++p)u.push(f.getX(p)+h);h+=i[d].attributes.position.count}l.setIndex(u)}for(let h in r){let u=dx(r[h]);if(!u)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+h+" attribute."),null;l.setAttribute(h,u)}for(let h in o){let u=o[h][0].length;if(u!==0){l.morphAttributes=l.morphAttributes||{},l.morphAttributes[h]=[];for(let d=0;d<u;++d){let f=[];for(let x=0;x<o[h].length;++x)f.push(o[h][x][d]);let p=dx(f);if(!p)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+h+" morphAttribute."),null;l.morphAttributes[h].push(p)}}}return l}function dx(i){let e,t,n,s=-1,r=0;for(let c=0;c<i.length;++c){let h=i[c];if(e===void 0&&(e=h.array.constructor),e!==h.array.constructor)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.array must be of consistent array types across matching attributes."),null;if(t===void 0&&(t=h.itemSize),t!==h.itemSize)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.itemSize must be consistent across matching attributes."),null;if(n===void 0&&(n=h.normalized),n!==h.normalized)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.normalized must be consistent across matching attributes."),null;if(s===-1&&(s=h.gpuType),s!==h.gpuType)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.gpuType must be consistent across matching attributes."),null;r+=h.count*t}let o=new e(r),a=new ct(o,t,n),l=0;for(let c=0;c<i.length;++c){let h=i[c];if(h.isInterleavedBufferAttribute){let u=l/t;for(let d=0,f=h.count;d<f;d++)for(let p=0;p<t;p++){let x=h.getComponent(d,p);a.setComponent(d+u,p,x)}}else o.set(h.array,l);l+=h.count*t}return s!==void 0&&(a.gpuType=s),a}function mx(i,e=1e-4){e=Math.max(e,Number.EPSILON);let t={},n=i.getIndex(),s=i.getAttribute("position"),r=n?n.count:s.count,o=0,a=Object.keys(i.attributes),l=[],c=new Map,h=[],u=["getX","getY","getZ","getW"],d=e*.5,f=Math.log10(1/e),p=Math.pow(10,f),x=d*p;for(let m=0;m<r;m++){let y=n?n.getX(m):m,S="";for(let b=0,A=a.length;b<A;b++){let R=a[b],v=i.getAttribute(R),T=v.itemSize;for(let D=0;D<T;D++)S+=`${Math.trunc(v[u[D]](y)*p+x)},`}S in t?h.push(t[S]):(l.push(y),t[S]=o,h.push(o),o++)}let g=i.clone();for(let m in i.attributes)g.setAttribute(m,fx(i.attributes[m],l,c));for(let m in i.morphAttributes)g.morphAttributes[m]=i.morphAttributes[m].map(y=>fx(y,l,c));return g.setIndex(h),g}function gx(i,e=Math.PI/3){let t=i.index?i.toNonIndexed():i,n=t.attributes.position,s=n.count,r;if(n.isBufferAttribute===!0&&n.itemSize===3&&n.normalized===!1)r=n.array;else{r=new Float64Array(s*3);for(let b=0;b<s;b++)r[3*b+0]=n.getX(b),r[3*b+1]=n.getY(b),r[3*b+2]=n.getZ(b)}let o=Math.cos(e),a=(1+1e-10)*100,l=s/3,c=new Float64Array(l*3);for(let b=0;b<l;b++){let A=9*b,R=r[A+0],v=r[A+1],T=r[A+2],D=r[A+3],P=r[A+4],k=r[A+5],O=r[A+6],z=r[A+7],I=r[A+8],H=O-D,X=z-P,G=I-k,ne=R-D,$=v-P,J=T-k,ee=X*J-G*$,we=G*ne-H*J,ke=H*$-X*ne,Z=1/(Math.sqrt(ee*ee+we*we+ke*ke)||1);c[3*b+0]=ee*Z,c[3*b+1]=we*Z,c[3*b+2]=ke*Z}let h=new Int32Array(s),u=new Float64Array(s*3),d=1;for(;d<s*2;)d<<=1;let f=d-1,p=new Int32Array(d),x=0;for(let b=0;b<s;b++){let A=3*b,R=Math.trunc(r[A+0]*a),v=Math.trunc(r[A+1]*a),T=Math.trunc(r[A+2]*a),D=(Math.imul(R,73856093)^Math.imul(v,19349663)^Math.imul(T,83492791))&f;for(;;){let P=p[D];if(P===0){let O=3*x;u[O+0]=R,u[O+1]=v,u[O+2]=T,p[D]=x+1,h[b]=x++;break}let k=3*(P-1);if(u[k+0]===R&&u[k+1]===v&&u[k+2]===T){h[b]=P-1;break}D=D+1&f}}let g=new Int32Array(x+1);for(let b=0;b<s;b++)g[h[b]+1]++;for(let b=0;b<x;b++)g[b+1]+=g[b];let m=new Int32Array(s),y=g.slice(0,x);for(let b=0;b<l;b++){let A=3*b;m[y[h[A+0]]++]=b,m[y[h[A+1]]++]=b,m[y[h[A+2]]++]=b}let S=new Float32Array(s*3);for(let b=0;b<l;b++){let A=3*b,R=c[A+0],v=c[A+1],T=c[A+2];for(let D=0;D<3;D++){let P=A+D,k=h[P],O=0,z=0,I=0;for(let X=g[k],G=g[k+1];X<G;X++){let ne=3*m[X],$=c[ne+0],J=c[ne+1],ee=c[ne+2];R*$+v*J+T*ee>o&&(O+=$,z+=J,I+=ee)}let H=1/(Math.sqrt(O*O+z*z+I*I)||1);S[3*P+0]=O*H,S[3*P+1]=z*H,S[3*P+2]=I*H}}return t.setAttribute("normal",new ct(S,3,!1)),t}function fx(i,e,t=new Map){let n=i.isInterleavedBufferAttribute,s=n?i.data:i,r=n?s.stride:i.itemSize,o=n?t.get(s):void 0;if(o===void 0){let l=new s.array.constructor(e.length*r);for(let c=0;c<e.length;c++)for(let h=0;h<r;h++)l[c*r+h]=s.array[e[c]*r+h];o=n?new s.constructor(l,r,s.meshPerAttribute):new i.constructor(l,i.itemSize,i.normalized,i.meshPerAttribute),o.setUsage(s.usage),n&&t.set(s,o)}let a=n?new i.constructor(o,i.itemSize,i.offset,i.normalized):o;return a.name=i.name,n||(a.gpuType=i.gpuType),a}var VT=new E(1,1,1),GT=.7;function At([i,e,t,n,s,r,o],a=new Le){return a.compose(new E(i,e,t),new Rt(n,s,r,o).normalize(),VT)}function $t(i,e){return i.matrixAutoUpdate=!1,At(e,i.matrix),i.matrixWorldNeedsUpdate=!0,i}function Et(i,e){return i.name=e,i.color.set(Me(e)),i}function yx(i){let e=[];return i.traverse(t=>{"material"in t&&e.push(t)}),e}function rp(i){for(let{material:e}of yx(i))e.name&&Et(e,e.name)}function eu(i){for(let e of yx(i))e.dispose?.(),e.geometry.dispose(),e.material.map?.dispose(),e.material.dispose()}function el(i){eu(i),i.clear()}function Fi(i,e){return i.onBeforeCompile=t=>{t.vertexShader=t.vertexShader.replace("#include <project_vertex>",`#include <project_vertex>
      gl_Position.z = (projectionMatrix * vec4(${e.toFixed(3)} * mvPosition.xyz, 1.0)).z / ${e.toFixed(3)};`)},i.customProgramCacheKey=()=>`shifted ${e}`,i}var xx=new WeakMap;function HT(i){if(!i)return new We;let e=xx.get(i);if(!e){let t=new We;t.setAttribute("position",new ct(Float32Array.from(i.vertices,n=>n/Lo),3)),t.setIndex(i.triangles),e=gx(t,GT),xx.set(i,e)}return e}function Bi(i,e){switch(i.kind){case"box":return new Nn(...i.size);case"sphere":return new Di(i.radius,28,18);case"cylinder":return new ns(i.radius,i.radius,i.length,32).rotateX(Math.PI/2);case"capsule":return new ks(i.radius,i.length,10,28).rotateX(Math.PI/2);case"mesh":return HT(e[i.mesh]);default:return new We}}function js(i){let e=document.createElement("canvas");e.width=e.height=64;let t=e.getContext("2d");return t.fillStyle=t.strokeStyle="#fff",t.beginPath(),i(t),new Ns(e)}var tu=()=>js(i=>{i.arc(32,32,24,0,2*Math.PI),i.fill(),i.lineWidth=5,i.strokeStyle="#000",i.stroke()});function ps(i,e,t,{nearer:n=.98,alphaTest:s=.3,renderOrder:r=7,vertexColors:o=!1}={}){let a=new We().setAttribute("position",new Ne(i,3)),l=new la(a,Fi(new Gr({size:t,sizeAttenuation:!1,map:e,alphaTest:s,transparent:!0,vertexColors:o}),n));return l.frustumCulled=!1,l.renderOrder=r,l}var vx=new WeakMap;function nu(i){let e=vx.get(i);if(e)return e;let[t,n]=[Math.cos(i.axis_rad),Math.sin(i.axis_rad)],[s,r]=[Math.cos(i.half_angle_rad),Math.sin(i.half_angle_rad)*Math.sign(i.radius_m)],o={along:[t,n],cosine:s,sine:r,slant:i.radius_m/r,axis:new E(s*t,s*n,-r),radial:new E(r*t,r*n,s),across:new E(-n,t,0)};return vx.set(i,o),o}function bx(i,e,t){let{along:n,slant:s,sine:r}=nu(i);return Math.atan2(n[0]*t-n[1]*e,s+n[0]*e+n[1]*t)/r}function _x(i,e,t,n){let{along:s,slant:r,sine:o,cosine:a,axis:l,radial:c,across:h}=nu(i),[u,d]=[s[0]*e+s[1]*t,s[0]*t-s[1]*e],f=(u*(2*r+u)+d*d)/(Math.hypot(r+u,d)+r),p=Math.atan2(d,r+u)/o,x=h.clone().multiplyScalar(Math.sin(p)).addScaledVector(c,-2*Math.sin(p/2)**2),g=x.clone().add(c);return x.multiplyScalar(i.radius_m).addScaledVector(l,a*f).addScaledVector(g,o*f).addScaledVector(g,a*n).addScaledVector(l,-o*n).toArray()}function wx(i,e){let{sine:t,cosine:n,axis:s,radial:r,across:o}=nu(i),[a,l]=[r.dot(e)+i.radius_m,o.dot(e)];return r.clone().multiplyScalar(a).addScaledVector(o,l).multiplyScalar(Math.sign(i.radius_m)).normalize().multiplyScalar(n).addScaledVector(s,-t)}function Mx(i,e){let{along:t,slant:n,sine:s}=nu(i),[r,o]=[Math.sin(e*s),Math.cos(e*s)];return(a,l)=>Math.sign(s)*(o*(t[0]*l-t[1]*a)-r*(n+t[0]*a+t[1]*l))}var op=class{constructor(e){this.shape=e;let{points:t,places:n,triangles:s}=e;this.geometry=new We,this.geometry.setAttribute("position",new ct(Float32Array.from(t),3)),this.geometry.setIndex([...s]),this.geometry.computeVertexNormals(),this.normals=this.geometry.getAttribute("normal").array;let r=new Vs;for(let a=0;a<n.length;a+=2)r.expandByPoint(new te(n[a],n[a+1]));this.low=r.min.toArray();let o=r.getSize(new te);this.cell=Math.max(Math.sqrt(3*o.x*o.y/Math.max(s.length,1)),1e-4),this.columns=Math.floor(o.x/this.cell)+1;for(let a=0;a<s.length;a+=3){let l=[0,1,2].map(u=>s[a+u]);l.forEach(u=>this.triangleOf[u]??=a);let[c,h]=[0,1].map(u=>{let d=l.map(f=>Math.floor((n[2*f+u]-this.low[u])/this.cell));return[Math.min(...d),Math.max(...d)]});for(let u=h[0];u<=h[1];u++)for(let d=c[0];d<=c[1];d++)(this.cells[u*this.columns+d]??=[]).push(a)}}shape;geometry;normals;low;cell;columns;cells=[];triangleOf=[];lift(e,t,n){let s=this.find(e,t),r=this.mean(this.shape.points,s),o=this.mean(this.normals,s).normalize();return r.addScaledVector(o,n).toArray()}normalNear(e){let{points:t}=this.shape,[n,s]=[0,1/0];for(let r=0;r<t.length;r+=3){let o=(t[r]-e.x)**2+(t[r+1]-e.y)**2+(t[r+2]-e.z)**2;o<s&&([n,s]=[r,o])}return new E().fromArray(this.normals,n)}mean(e,{corners:t,weights:n}){let s=new E;return t.forEach((r,o)=>{s.x+=n[o]*e[3*r],s.y+=n[o]*e[3*r+1],s.z+=n[o]*e[3*r+2]}),s}find(e,t){let[n,s]=[Math.floor((e-this.low[0])/this.cell),Math.floor((t-this.low[1])/this.cell)],r=n>=0&&n<this.columns&&s>=0?this.cells[s*this.columns+n]??[]:[];for(let c of r){let h=this.locate(c,e,t);if(h.weights.every(u=>u>=-1e-6))return h}let{places:o}=this.shape,[a,l]=[0,1/0];for(let c=0;c<this.triangleOf.length;c++){let h=(o[2*c]-e)**2+(o[2*c+1]-t)**2;h<l&&([a,l]=[c,h])}return this.locate(this.triangleOf[a]??0,e,t)}locate(e,t,n){let{places:s,triangles:r}=this.shape,o=[r[e],r[e+1],r[e+2]],[a,l,c]=[2*o[0],2*o[1],2*o[2]],[h,u,d,f,p,x]=[s[a],s[a+1],s[l],s[l+1],s[c],s[c+1]],g=(d-h)*(x-u)-(f-u)*(p-h),m=((t-h)*(x-u)-(n-u)*(p-h))/g,y=((d-h)*(n-u)-(f-u)*(t-h))/g;return{corners:o,weights:[1-m-y,m,y]}}},Sx=new WeakMap;function tl(i){let e=Sx.get(i);if(e)return e;let t=new op(i);return Sx.set(i,t),t}var Ex=.05,Ax=.02,Rx=500,WT=64;function lp({axis_rad:i}){let[e,t]=[Math.cos(i),Math.sin(i)];return[[e,t],[-t,e]]}function iu(i,e,t){if(i.kind==="cone")return bx(i,e,t);let[,n]=lp(i);return(n[0]*e+n[1]*t)/i.radius_m}function $T(i,e,t){let n=i.kind==="mesh"?Math.hypot(t[0]-e[0],t[1]-e[1])/Ax:Math.abs(iu(i,t[0],t[1])-iu(i,e[0],e[1]))/Ex;return Math.min(Rx,Math.max(1,Math.ceil(n)))}function ri(i,e,t,n){if(!i)return[e,t,n];if(i.kind==="mesh")return tl(i).lift(e,t,n);if(i.kind==="cone")return _x(i,e,t,n);let[s,r]=lp(i),o=s[0]*e+s[1]*t,a=(r[0]*e+r[1]*t)/i.radius_m,l=(i.radius_m+n)*Math.sin(a);return[s[0]*o+r[0]*l,s[1]*o+r[1]*l,n*Math.cos(a)-2*i.radius_m*Math.sin(a/2)**2]}function ms({pose:i,shape:e},t){let n=At(i),s=new E(0,0,1),r=t.clone().applyMatrix4(n.clone().invert());if(e?.kind==="mesh")s.copy(tl(e).normalNear(r));else if(e?.kind==="cone")s.copy(wx(e,r));else if(e){let[,o]=lp(e),[a,l]=[o[0]*r.x+o[1]*r.y,r.z+e.radius_m];s.set(o[0]*a,o[1]*a,l).multiplyScalar(Math.sign(e.radius_m)).normalize()}return s.transformDirection(n)}function Cx({pose:i,rings:e,shape:t},[n,s,r]){if(t||!e.length)return!0;let o=new E(n,s,r).applyMatrix4(At(i).invert());return e.map(a=>lt(a)).filter(a=>{let l=!1;for(let c=0,h=a.length-2;c<a.length;h=c,c+=2){let[u,d,f,p]=[a[c],a[c+1],a[h],a[h+1]];d>o.y!=p>o.y&&o.x<u+(f-u)*(o.y-d)/(p-d)&&(l=!l)}return l}).length%2===1}function gs(i,e,t){if(!i)return[...e];let n=[];for(let s=0;s<e.length;s++){let[r,o,a]=e[s],l=s+1<e.length?e[s+1]:t?e[0]:null,c=l?$T(i,e[s],l):1;for(let h=0;h<c;h++){let u=h/c,d=l??e[s];n.push(ri(i,r+u*(d[0]-r),o+u*(d[1]-o),a+u*(d[2]-a)))}}return n}function Tx(i,e){let t=[];return i.forEach((n,s)=>{let r=i[(s+1)%i.length],[o,a]=[e(n),e(r)];if(o>=0&&t.push(n),o>=0!=a>=0){let l=o/(o-a);t.push([n[0]+l*(r[0]-n[0]),n[1]+l*(r[1]-n[1]),n[2]+l*(r[2]-n[2])])}}),t}function XT(i){let e=t=>{if(i.kind==="cylinder")return([s,r])=>iu(i,s,r)-t;let n=Mx(i,t);return([s,r])=>n(s,r)};return(t,n)=>{let s=t.map(([c,h])=>iu(i,c,h)),[r,o]=[Math.min(...s),Math.max(...s)],a=Math.max(Ex,(o-r)/Rx),l=Math.floor(r/a);for(let c=l;c<Math.max(o/a,l+.5);c++){let[h,u]=[e(c*a),e((c+1)*a)],d=Tx(Tx(t,h),f=>-u(f));for(let f=1;f+1<d.length;f++)n([d[0],d[f],d[f+1]])}}}function ap([i,e,t],n,s=0){let r=[[i,e],[e,t],[t,i]].map(([d,f])=>Math.hypot(d[0]-f[0],d[1]-f[1])),o=r.indexOf(Math.max(...r)),a=s||Math.max(Ax,r[o]/WT);if(r[o]<=a)return n([i,e,t]);let[l,c,h]=[[i,e,t],[e,t,i],[t,i,e]][o],u=[(l[0]+c[0])/2,(l[1]+c[1])/2,(l[2]+c[2])/2];ap([l,u,h],n,a),ap([u,c,h],n,a)}function cp(i,e){if(!i)return e;let t=e.index?e.toNonIndexed():e,{array:n,count:s}=t.getAttribute("position"),r=[],o=i.kind==="mesh"?ap:XT(i),a=c=>{for(let[h,u,d]of c)r.push(...ri(i,h,u,d))};for(let c=0;c+2<s;c+=3){let h=u=>[n[3*(c+u)],n[3*(c+u)+1],n[3*(c+u)+2]];o([h(0),h(1),h(2)],a)}let l=new We;return l.setAttribute("position",new ct(Float32Array.from(r),3)),l.computeVertexNormals(),e.dispose(),l}var Px={low:.8,high:1.25},qT=.006,YT=.12,ZT=2.2,jT=.15,KT=.5,ro=[{colour:"force-little",label:"below 80\u202F%"},{colour:"force-target",label:"on target"},{colour:"force-much",label:"above 125\u202F%"}],JT=ro.length;function QT(i,e){return e===null?JT:i<Px.low*e?0:i<=Px.high*e?1:2}var su=class{constructor(e,t){this.most=e;this.target=t;let{geometry:n}=this.mesh;this.corners=new ct(new Float32Array(12*e),3),this.colours=new ct(new Float32Array(16*e),4),n.setAttribute("position",this.corners),n.setAttribute("color",this.colours),n.setIndex(Array.from({length:6*e},(s,r)=>4*Math.floor(r/6)+[0,1,2,2,1,3][r%6])),this.mesh.frustumCulled=!1,this.mesh.renderOrder=1,this.paint()}most;target;mesh=new st(new We,new cn({vertexColors:!0,side:hn,transparent:!0,depthWrite:!1,polygonOffset:!0,polygonOffsetFactor:-8,polygonOffsetUnits:-8}));times=[];degrees=[];corners;colours;end=null;peak=0;selected=null;palette=[];clear(){this.breakOff(),this.times.length=this.degrees.length=0}breakOff(){this.end=null,this.peak=0}push(e,t,n,s,{step:r,reference:o}){this.peak=Math.max(this.peak,s);let a=qT*Math.min(ZT,Math.max(YT,this.peak/o)),l=this.end??={place:t,half:a,way:null,corners:null};if(t.distanceTo(l.place)<r||this.times.length===this.most)return;let c=t.clone().sub(l.place).normalize(),h=n.clone().cross(c).normalize(),u=(x,g)=>[x.clone().addScaledVector(h,g),x.clone().addScaledVector(h,-g)],d=l.corners&&l.way.dot(c)>KT?l.corners:u(l.place,l.half),f=u(t,a),p=this.times.length;[...d,...f].forEach(({x,y:g,z:m},y)=>this.corners.setXYZ(4*p+y,x,g,m)),this.corners.needsUpdate=!0,this.times.push(e),this.degrees.push(QT(this.peak,this.target)),this.colour(p),this.end={place:t,half:a,way:c,corners:f},this.peak=0}show(e,t){let n=Math.max(e,this.selected?.[1]??-1/0),s=li(this.times,n)+1;this.mesh.visible=t&&s>0,this.mesh.geometry.setDrawRange(0,6*s)}select(e){this.selected=e;for(let t=0;t<this.times.length;t++)this.colour(t)}paint(){this.palette=[...ro.map(e=>e.colour),"contact"].map(e=>new Re(Me(e)));for(let e=0;e<this.times.length;e++)this.colour(e)}colour(e){let{r:t,g:n,b:s}=this.palette[this.degrees[e]],[r,o]=this.selected??[-1/0,1/0],a=this.times[e]>=r&&this.times[e]<=o?1:jT;for(let l=0;l<4;l++)this.colours.setXYZW(4*e+l,t,n,s,a);this.colours.needsUpdate=!0}};pe.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new te},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};yn.line={uniforms:Wa.merge([pe.common,pe.fog,pe.line]),vertexShader:`
		#include <common>
		#include <color_pars_vertex>
		#include <fog_pars_vertex>
		#include <logdepthbuf_pars_vertex>
		#include <clipping_planes_pars_vertex>

		uniform float linewidth;
		uniform vec2 resolution;

		attribute vec3 instanceStart;
		attribute vec3 instanceEnd;

		attribute vec3 instanceColorStart;
		attribute vec3 instanceColorEnd;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#ifdef USE_DASH

			uniform float dashScale;
			attribute float instanceDistanceStart;
			attribute float instanceDistanceEnd;
			varying float vLineDistance;

		#endif

		float trimSegmentAlpha( const in vec4 start, const in vec4 end ) {

			// compute the interpolation factor needed to trim the segment so it terminates
			// between the camera plane and the near plane

			// conservative estimate of the near plane
			float a = projectionMatrix[ 2 ][ 2 ]; // 3nd entry in 3th column
			float b = projectionMatrix[ 3 ][ 2 ]; // 3nd entry in 4th column

			// we need different nearEstimate formula for reversed and default depth buffer
			// a is positive with a reversed depth buffer so it can be used for controlling the code flow
			float nearEstimate = ( a > 0.0 ) ? ( - b / ( a + 1.0 ) ) : ( - 0.5 * b / a );

			return ( nearEstimate - start.z ) / ( end.z - start.z );

		}

		void main() {

			#ifdef USE_COLOR

				vColor.xyz = ( position.y < 0.5 ) ? instanceColorStart : instanceColorEnd;

			#endif

			float aspect = resolution.x / resolution.y;

			// camera space
			vec4 start = modelViewMatrix * vec4( instanceStart, 1.0 );
			vec4 end = modelViewMatrix * vec4( instanceEnd, 1.0 );

			#ifdef USE_DASH

				float lineDistanceStart = dashScale * instanceDistanceStart;
				float lineDistanceEnd = dashScale * instanceDistanceEnd;

			#endif

			#ifdef WORLD_UNITS

				worldStart = start.xyz;
				worldEnd = end.xyz;

			#else

				vUv = uv;

			#endif

			// special case for perspective projection, and segments that terminate either in, or behind, the camera plane
			// clearly the gpu firmware has a way of addressing this issue when projecting into ndc space
			// but we need to perform ndc-space calculations in the shader, so we must address this issue directly
			// perhaps there is a more elegant solution -- WestLangley

			bool perspective = ( projectionMatrix[ 2 ][ 3 ] == - 1.0 ); // 4th entry in the 3rd column

			if ( perspective ) {

				if ( start.z < 0.0 && end.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( start, end );
					end.xyz = mix( start.xyz, end.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceEnd = mix( lineDistanceStart, lineDistanceEnd, alpha );

					#endif

				} else if ( end.z < 0.0 && start.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( end, start );
					start.xyz = mix( end.xyz, start.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceStart = mix( lineDistanceEnd, lineDistanceStart, alpha );

					#endif

				}

			}

			#ifdef USE_DASH

				vLineDistance = ( position.y < 0.5 ) ? lineDistanceStart : lineDistanceEnd;
				vUv = uv;

			#endif

			// clip space
			vec4 clipStart = projectionMatrix * start;
			vec4 clipEnd = projectionMatrix * end;

			// ndc space
			vec3 ndcStart = clipStart.xyz / clipStart.w;
			vec3 ndcEnd = clipEnd.xyz / clipEnd.w;

			// direction
			vec2 dir = ndcEnd.xy - ndcStart.xy;

			// account for clip-space aspect ratio
			dir.x *= aspect;
			dir = normalize( dir );

			#ifdef WORLD_UNITS

				vec3 worldDir = normalize( end.xyz - start.xyz );
				vec3 tmpFwd = perspective ? normalize( mix( start.xyz, end.xyz, 0.5 ) ) : vec3( 0.0, 0.0, - 1.0 );
				vec3 worldUp = normalize( cross( worldDir, tmpFwd ) );
				vec3 worldFwd = cross( worldDir, worldUp );
				worldPos = position.y < 0.5 ? start: end;

				// height offset
				float hw = linewidth * 0.5;
				worldPos.xyz += position.x < 0.0 ? hw * worldUp : - hw * worldUp;

				// don't extend the line if we're rendering dashes because we
				// won't be rendering the endcaps
				#ifndef USE_DASH

					// cap extension
					worldPos.xyz += position.y < 0.5 ? - hw * worldDir : hw * worldDir;

					// add width to the box
					worldPos.xyz += worldFwd * hw;

					// endcaps
					if ( position.y > 1.0 || position.y < 0.0 ) {

						worldPos.xyz -= worldFwd * 2.0 * hw;

					}

				#endif

				// project the worldpos
				vec4 clip = projectionMatrix * worldPos;

				// shift the depth of the projected points so the line
				// segments overlap neatly
				vec3 clipPose = ( position.y < 0.5 ) ? ndcStart : ndcEnd;

				// only shift the depth of vertices in front of the camera (#35137)
				if ( clip.w > 0.0 ) clip.z = clipPose.z * clip.w;

			#else

				vec2 offset = vec2( dir.y, - dir.x );
				// undo aspect ratio adjustment
				dir.x /= aspect;
				offset.x /= aspect;

				// sign flip
				if ( position.x < 0.0 ) offset *= - 1.0;

				// endcaps
				if ( position.y < 0.0 ) {

					offset += - dir;

				} else if ( position.y > 1.0 ) {

					offset += dir;

				}

				// adjust for linewidth
				offset *= linewidth;

				// adjust for clip-space to screen-space conversion // maybe resolution should be based on viewport ...
				offset /= resolution.y;

				// select end
				vec4 clip = ( position.y < 0.5 ) ? clipStart : clipEnd;

				// back to clip space
				offset *= clip.w;

				clip.xy += offset;

			#endif

			gl_Position = clip;

			vec4 mvPosition = ( position.y < 0.5 ) ? start : end; // this is an approximation

			#include <logdepthbuf_vertex>
			#include <clipping_planes_vertex>
			#include <fog_vertex>

		}
		`,fragmentShader:`
		uniform vec3 diffuse;
		uniform float opacity;
		uniform float linewidth;

		#ifdef USE_DASH

			uniform float dashOffset;
			uniform float dashSize;
			uniform float gapSize;

		#endif

		varying float vLineDistance;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#include <common>
		#include <color_pars_fragment>
		#include <fog_pars_fragment>
		#include <logdepthbuf_pars_fragment>
		#include <clipping_planes_pars_fragment>

		vec2 closestLineToLine(vec3 p1, vec3 p2, vec3 p3, vec3 p4) {

			float mua;
			float mub;

			vec3 p13 = p1 - p3;
			vec3 p43 = p4 - p3;

			vec3 p21 = p2 - p1;

			float d1343 = dot( p13, p43 );
			float d4321 = dot( p43, p21 );
			float d1321 = dot( p13, p21 );
			float d4343 = dot( p43, p43 );
			float d2121 = dot( p21, p21 );

			float denom = d2121 * d4343 - d4321 * d4321;

			float numer = d1343 * d4321 - d1321 * d4343;

			mua = numer / denom;
			mua = clamp( mua, 0.0, 1.0 );
			mub = ( d1343 + d4321 * ( mua ) ) / d4343;
			mub = clamp( mub, 0.0, 1.0 );

			return vec2( mua, mub );

		}

		void main() {

			float alpha = opacity;
			vec4 diffuseColor = vec4( diffuse, alpha );

			#include <clipping_planes_fragment>

			#ifdef USE_DASH

				if ( vUv.y < - 1.0 || vUv.y > 1.0 ) discard; // discard endcaps

				if ( mod( vLineDistance + dashOffset, dashSize + gapSize ) > dashSize ) discard; // todo - FIX

			#endif

			#ifdef WORLD_UNITS

				float len;

				if ( isOrthographic ) {

					// View rays are parallel to the z axis so the distance reduces to camera-space XY
					vec2 lineDir = worldEnd.xy - worldStart.xy;
					float t = clamp( dot( worldPos.xy - worldStart.xy, lineDir ) / dot( lineDir, lineDir ), 0.0, 1.0 );
					len = length( worldStart.xy + lineDir * t - worldPos.xy );

				} else {

					// Find the closest points on the view ray and the line segment
					vec3 rayEnd = normalize( worldPos.xyz ) * 1e5;
					vec3 lineDir = worldEnd - worldStart;
					vec2 params = closestLineToLine( worldStart, worldEnd, vec3( 0.0, 0.0, 0.0 ), rayEnd );

					vec3 p1 = worldStart + lineDir * params.x;
					vec3 p2 = rayEnd * params.y;
					vec3 delta = p1 - p2;
					len = length( delta );

				}

				float norm = len / linewidth;

				#ifndef USE_DASH

					#ifdef USE_ALPHA_TO_COVERAGE

						float dnorm = fwidth( norm );
						alpha = 1.0 - smoothstep( 0.5 - dnorm, 0.5 + dnorm, norm );

					#else

						if ( norm > 0.5 ) {

							discard;

						}

					#endif

				#endif

			#else

				#ifdef USE_ALPHA_TO_COVERAGE

					// artifacts appear on some hardware if a derivative is taken within a conditional
					float a = vUv.x;
					float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
					float len2 = a * a + b * b;
					float dlen = fwidth( len2 );

					if ( abs( vUv.y ) > 1.0 ) {

						alpha = 1.0 - smoothstep( 1.0 - dlen, 1.0 + dlen, len2 );

					}

				#else

					if ( abs( vUv.y ) > 1.0 ) {

						float a = vUv.x;
						float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
						float len2 = a * a + b * b;

						if ( len2 > 1.0 ) discard;

					}

				#endif

			#endif

			#include <logdepthbuf_fragment>
			#include <color_fragment>

			gl_FragColor = vec4( diffuseColor.rgb, alpha );

			#include <tonemapping_fragment>
			#include <colorspace_fragment>
			#include <fog_fragment>
			#include <premultiplied_alpha_fragment>

		}
		`};var Xt=class extends $n{constructor(e){super({type:"LineMaterial",uniforms:Wa.clone(yn.line.uniforms),vertexShader:yn.line.vertexShader,fragmentShader:yn.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(e)}get color(){return this.uniforms.diffuse.value}set color(e){this.uniforms.diffuse.value=e}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(e){e===!0!==this.worldUnits&&(this.needsUpdate=!0),e===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(e){this.uniforms.linewidth&&(this.uniforms.linewidth.value=e)}get dashed(){return"USE_DASH"in this.defines}set dashed(e){e===!0!==this.dashed&&(this.needsUpdate=!0),e===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(e){this.uniforms.dashScale.value=e}get dashSize(){return this.uniforms.dashSize.value}set dashSize(e){this.uniforms.dashSize.value=e}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(e){this.uniforms.dashOffset.value=e}get gapSize(){return this.uniforms.gapSize.value}set gapSize(e){this.uniforms.gapSize.value=e}get opacity(){return this.uniforms.opacity.value}set opacity(e){this.uniforms&&(this.uniforms.opacity.value=e)}get resolution(){return this.uniforms.resolution.value}set resolution(e){this.uniforms.resolution.value.copy(e)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(e){this.defines&&(e===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),e===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var Ix=new kt,ru=new E,Ks=class extends La{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let e=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],t=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],n=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(n),this.setAttribute("position",new Ne(e,3)),this.setAttribute("uv",new Ne(t,2))}applyMatrix4(e){let t=this.attributes.instanceStart,n=this.attributes.instanceEnd;return t!==void 0&&(t.applyMatrix4(e),n.applyMatrix4(e),t.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let n=new os(t,6,1);return this.setAttribute("instanceStart",new Mn(n,3,0)),this.setAttribute("instanceEnd",new Mn(n,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let n=new os(t,6,1);return this.setAttribute("instanceColorStart",new Mn(n,3,0)),this.setAttribute("instanceColorEnd",new Mn(n,3,3)),this}fromWireframeGeometry(e){return this.setPositions(e.attributes.position.array),this}fromEdgesGeometry(e){return this.setPositions(e.attributes.position.array),this}fromMesh(e){return this.fromWireframeGeometry(new wa(e.geometry)),this}fromLineSegments(e){let t=e.geometry;return this.setPositions(t.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new kt);let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;e!==void 0&&t!==void 0&&(this.boundingBox.setFromBufferAttribute(e),Ix.setFromBufferAttribute(t),this.boundingBox.union(Ix))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ln),this.boundingBox===null&&this.computeBoundingBox();let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;if(e!==void 0&&t!==void 0){let n=this.boundingSphere.center;this.boundingBox.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)ru.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(ru)),ru.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(ru));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};var hp=new ft,Lx=new E,Dx=new E,Kt=new ft,Jt=new ft,xi=new ft,up=new E,dp=new Le,Qt=new Da,Nx=new E,ou=new kt,au=new ln,yi=new ft,vi,Js;function kx(i,e,t){return yi.set(0,0,-e,1).applyMatrix4(i.projectionMatrix),yi.multiplyScalar(1/yi.w),yi.x=Js/t.width,yi.y=Js/t.height,yi.applyMatrix4(i.projectionMatrixInverse),yi.multiplyScalar(1/yi.w),Math.abs(Math.max(yi.x,yi.y))}function eE(i,e){let t=i.matrixWorld,n=i.geometry,s=n.attributes.instanceStart,r=n.attributes.instanceEnd,o=Math.min(n.instanceCount,s.count);for(let a=0,l=o;a<l;a++){Qt.start.fromBufferAttribute(s,a),Qt.end.fromBufferAttribute(r,a),Qt.applyMatrix4(t);let c=new E,h=new E;vi.distanceSqToSegment(Qt.start,Qt.end,h,c),h.distanceTo(c)<Js*.5&&e.push({point:h,pointOnLine:c,distance:vi.origin.distanceTo(h),object:i,face:null,faceIndex:a,uv:null,uv1:null})}}function tE(i,e,t){let n=e.projectionMatrix,r=i.material.resolution,o=i.matrixWorld,a=i.geometry,l=a.attributes.instanceStart,c=a.attributes.instanceEnd,h=Math.min(a.instanceCount,l.count),u=-e.near;vi.at(1,xi),xi.w=1,xi.applyMatrix4(e.matrixWorldInverse),xi.applyMatrix4(n),xi.multiplyScalar(1/xi.w),xi.x*=r.x/2,xi.y*=r.y/2,xi.z=0,up.copy(xi),dp.multiplyMatrices(e.matrixWorldInverse,o);for(let d=0,f=h;d<f;d++){if(Kt.fromBufferAttribute(l,d),Jt.fromBufferAttribute(c,d),Kt.w=1,Jt.w=1,Kt.applyMatrix4(dp),Jt.applyMatrix4(dp),Kt.z>u&&Jt.z>u)continue;if(Kt.z>u){let S=Kt.z-Jt.z,b=(Kt.z-u)/S;Kt.lerp(Jt,b)}else if(Jt.z>u){let S=Jt.z-Kt.z,b=(Jt.z-u)/S;Jt.lerp(Kt,b)}Kt.applyMatrix4(n),Jt.applyMatrix4(n),Kt.multiplyScalar(1/Kt.w),Jt.multiplyScalar(1/Jt.w),Kt.x*=r.x/2,Kt.y*=r.y/2,Jt.x*=r.x/2,Jt.y*=r.y/2,Qt.start.copy(Kt),Qt.start.z=0,Qt.end.copy(Jt),Qt.end.z=0;let x=Qt.closestPointToPointParameter(up,!0);Qt.at(x,Nx);let g=Qr.lerp(Kt.z,Jt.z,x),m=g>=-1&&g<=1,y=up.distanceTo(Nx)<Js*.5;if(m&&y){Qt.start.fromBufferAttribute(l,d),Qt.end.fromBufferAttribute(c,d),Qt.start.applyMatrix4(o),Qt.end.applyMatrix4(o);let S=new E,b=new E;vi.distanceSqToSegment(Qt.start,Qt.end,b,S),t.push({point:b,pointOnLine:S,distance:vi.origin.distanceTo(b),object:i,face:null,faceIndex:d,uv:null,uv1:null})}}}var lu=class extends st{constructor(e=new Ks,t=new Xt({color:Math.random()*16777215})){super(e,t),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let e=this.geometry,t=e.attributes.instanceStart,n=e.attributes.instanceEnd,s=new Float32Array(2*t.count);for(let o=0,a=0,l=t.count;o<l;o++,a+=2)Lx.fromBufferAttribute(t,o),Dx.fromBufferAttribute(n,o),s[a]=a===0?0:s[a-1],s[a+1]=s[a]+Lx.distanceTo(Dx);let r=new os(s,2,1);return e.setAttribute("instanceDistanceStart",new Mn(r,1,0)),e.setAttribute("instanceDistanceEnd",new Mn(r,1,1)),this}raycast(e,t){let n=this.material.worldUnits,s=e.camera;if(s===null&&!n&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.'),n===!1&&(this.material.resolution.x===0||this.material.resolution.y===0))return;let r=e.params.Line2!==void 0&&e.params.Line2.threshold||0;vi=e.ray;let o=this.matrixWorld,a=this.geometry,l=this.material;Js=l.linewidth+r,a.boundingSphere===null&&a.computeBoundingSphere(),au.copy(a.boundingSphere).applyMatrix4(o);let c;if(n)c=Js*.5;else{let u=Math.max(s.near,au.distanceToPoint(vi.origin));c=kx(s,u,l.resolution)}if(au.radius+=c,vi.intersectsSphere(au)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),ou.copy(a.boundingBox).applyMatrix4(o);let h;if(n)h=Js*.5;else{let u=Math.max(s.near,ou.distanceToPoint(vi.origin));h=kx(s,u,l.resolution)}ou.expandByScalar(h),vi.intersectsBox(ou)!==!1&&(n?eE(this,t):tE(this,s,t))}onBeforeRender(e){let t=this.material.uniforms;t&&t.resolution&&(e.getViewport(hp),this.material.uniforms.resolution.value.set(hp.z,hp.w))}};var nE={polygonOffset:!0,polygonOffsetFactor:-4,polygonOffsetUnits:-4};function Fn(i,e){let t=new lu(new Ks,e);return t.frustumCulled=!1,nl(t,i),t}function nl(i,e){i.geometry.dispose(),i.geometry=new Ks().setPositions(e.length?Float32Array.from(e):new Float32Array(6)),i.visible=e.length>0}function xs(i,e){let t=[];for(let n=0;n+(e?0:1)<i.length;n++)t.push(...i[n],...i[(n+1)%i.length]);return t}var iE=2e3;function cu(i,e){let t=[],n=0,s=c=>Math.hypot(i[c+3]-i[c],i[c+4]-i[c+1],i[c+5]-i[c+2]),r=0;for(let c=0;c+5<i.length;c+=6)r+=s(c);let o=Math.max(1,r/(iE*(e[0]+e[1]))),[a,l]=[o*e[0],o*e[1]];for(let c=0;c+5<i.length;c+=6){let h=d=>[0,1,2].map(f=>i[c+f]+d*(i[c+3+f]-i[c+f])),u=s(c);for(let d=-(n%(a+l));d<u;d+=a+l){let[f,p]=[Math.max(0,d),Math.min(u,d+a)];p>f&&t.push(...h(f/u),...h(p/u))}n+=u}return t}var oo=class{constructor(e,t){this.palette=t;this.line=Fn([],new Xt({linewidth:e,vertexColors:!0,...nE}))}palette;line;positions=[];kinds=[];changed=!0;get count(){return this.kinds.length}clear(){this.positions.length=this.kinds.length=0,this.changed=!0}push(e,t){for(let n of e)this.positions.push(n);this.kinds.push(t),this.changed=!0}end(e){return new E().fromArray(this.positions,6*e+3)}paint(e){this.palette=e,this.changed=!0}show(e){this.changed&&this.upload(),this.line.geometry.instanceCount=Math.min(e,this.count),this.line.visible=e>0}upload(){this.changed=!1;let{geometry:e}=this.line;e.dispose();let t=6*Math.max(1,this.count),n=new Float32Array(t);for(let s=0;s<this.count;s++)for(let r of[6*s,6*s+3])this.palette[this.kinds[s]].toArray(n,r);e.setPositions(this.count?this.positions:new Float32Array(t)).setColors(n)}};var sE={axis:"",rounds:"Round",phases:"Phase, stroke",contact:"Contact",events:"Events",force:"Force [N]",height:`Tool height
[mm]`,performance:`Performance
[%]`},rE={axis:20,rounds:20,phases:18,contact:12,events:18,force:74,height:50,performance:88},il=[3,2],Ox=[1,4],fp=new Set(["force","height","performance"]),oE=4,hu=class{constructor(e){this.names=e}names;lanes=[];left=112;right=22;width=600;height=0;from=0;to=1;layOut(e,t){this.width=e;let n=e<560;this.left=n?34:112;let s=0;this.lanes=this.names.map(r=>{let o=fp.has(r);n&&o&&(s+=13);let a={name:r,label:sE[r],top:s,height:Math.round(rE[r]*(o&&t?.66:1))};return s+=a.height+oE+(o?4:0),a}),this.height=s}get narrow(){return this.left<100}get span(){return this.width-this.left-this.right}x(e){return this.left+(e-this.from)/(this.to-this.from)*this.span}t(e){return this.from+(e-this.left)/this.span*(this.to-this.from)}lane(e){return this.lanes.find(t=>t.name===e)}},aE=[.01,.02,.05,.1,.2,.5,1,2,5,10,20,30,60,120,300,600,1200,1800,3600,7200];function uu(i,e,t){let n=aE.find(r=>(e-i)/r<=t)??(e-i)/t,s=[];for(let r=Math.ceil(i/n-1e-9);r*n<=e+1e-9;r++)s.push(r*n);return{step:n,times:s}}function Ux(i,e,t){let n=(e-i)/t,s=10**Math.floor(Math.log10(n)),r=[1,2,5,10].map(a=>a*s).find(a=>a>=n*.999)??n,o=[];for(let a=Math.ceil(i/r-1e-9);a*r<=e+1e-9*r;a++)o.push(a*r);return o}function qn(i,e=11,{weight:t=400,align:n="left",base:s="middle"}={}){i.font=`${t} ${e}px system-ui, -apple-system, "Segoe UI", Roboto, sans-serif`,i.textAlign=n,i.textBaseline=s}function pp(i,e,{top:t,height:n}){i.fillStyle=Me("lane"),i.fillRect(e.left,t,e.span,n)}function sl(i,[e,t,n,s],r){i.save(),i.beginPath(),i.rect(e,t,n,s),i.clip(),r(),i.restore()}function ys(i,e,t,n,s){if(s<14)return;let r=e.length>200?e.slice(0,200):e;if(i.measureText(r).width>s){for(;r.length>1&&i.measureText(`${r}\u2026`).width>s;)r=r.slice(0,-1);if(r.length<3)return;r+="\u2026"}i.fillText(r,t,n)}function en(i,e,t,n,s,r,o=1){i.strokeStyle=Me(r),i.lineWidth=o,i.beginPath(),i.moveTo(e,t),i.lineTo(n,s),i.stroke()}var lE=1.12,cE=1.8,Fx=16,hE=[.45,.7,.95];function mp(i,e){for(let t of i)if(t.visible){if(t instanceof st){let n=t.geometry;n.boundingBox||n.computeBoundingBox(),n.boundingBox.isEmpty()||e(t,n.boundingBox)}mp(t.children,e)}}function Qs(i){let e=[];return mp(i,({matrixWorld:t},{min:n,max:s})=>{for(let r=0;r<8;r++)e.push(new E(r&1?s.x:n.x,r&2?s.y:n.y,r&4?s.z:n.z).applyMatrix4(t))}),e}function du(i){let e=[];return mp(i,({matrixWorld:t},n)=>e.push({blockFromWorld:t.clone().invert(),box:n})),e}function gp({blockFromWorld:i,box:e},t,n){let s=t.clone().applyMatrix4(i),r=n.clone().applyMatrix4(i).sub(s),o=new fi(s,r.clone().normalize()).intersectBox(e,new E);return e.containsPoint(s)||o!==null&&o.distanceTo(s)<r.length()}function Bx(i,e,t){return i.length?i.filter(n=>{let s=n.clone().addScaledVector(e,cE);return!t.some(r=>gp(r,n,s))}).length/i.length:1}function zx(i,e,t,n){let[s,r]=[n,-1/0];for(let o of hE)for(let a=0;a<Fx;a++){let l=2*Math.PI*a/Fx,c=new E(Math.cos(o)*Math.cos(l),Math.cos(o)*Math.sin(l),Math.sin(o)),h=c.dot(t);if(h<.2)continue;let u=0;for(let{blocks:f,tool:p}of i)u+=(3*Bx(p,c,f)+2*Bx(e,c,f))/i.length;let d=u+2*Math.min(h,.8)+.6*c.dot(n);d>r&&([s,r]=[c,d])}return s}var fu=i=>i.reduce((e,t)=>e.addScaledVector(t,1/i.length),new E);function pu(i,e,{high:t,wide:n}){if(!i.length)return null;let s=e.clone().normalize(),r=new E().crossVectors(new E(0,0,1),s).normalize(),o=new E().crossVectors(s,r),a=h=>{let u=i.map(d=>d.dot(h));return(Math.min(...u)+Math.max(...u))/2},l=new E().addScaledVector(r,a(r)).addScaledVector(o,a(o)).addScaledVector(s,a(s)),c=()=>Math.max(.1,...i.map(h=>{let u=h.clone().sub(l);return u.dot(s)+lE*Math.max(Math.abs(u.dot(r))/n,Math.abs(u.dot(o))/t)}));for(let h=0;h<3;h++){let u=c(),d=x=>{let g=i.map(m=>{let y=m.clone().sub(l);return y.dot(x)/Math.max(.05,u-y.dot(s))});return(Math.min(...g)+Math.max(...g))/2*u},[f,p]=[d(r),d(o)];l.addScaledVector(r,f).addScaledVector(o,p)}return{target:l,eye:l.clone().addScaledVector(s,c())}}var zi=256,uE=.24,xp=4,dE=.04,fE=.05,Vi=null;function Vx(){if(Vi)return Vi;let i=document.createElement("canvas");i.width=i.height=zi;let e=i.getContext("2d"),t=e.createImageData(zi,zi);for(let n=0;n<zi;n++)for(let s=0;s<zi;s++){let r=Math.floor(xp*n/zi),o=2*Math.PI*s/zi,a=n+5*Math.sin(o+2.1*r)+2*Math.sin(2*o+r),l=.5+.25*Math.sin(.55*a+3*r)+.25*Math.sin(1.63*a+r),c=xp*n%zi<xp?.06:0,h=255*(1-dE*Math.abs(Math.sin(5.3*r+1))-fE*l**3-c);t.data.set([h,h,h,255],4*(zi*n+s))}return e.putImageData(t,0,0),Vi=new Ns(i),Vi.wrapS=Vi.wrapT=Lr,Vi.repeat.setScalar(1/uE),Vi.colorSpace=jt,Vi.anisotropy=4,Vi}var En=.0015,yp=[.005*il[0],.005*il[1]],pE=.2,mE=.03,gE=/board|table|wood|desk|counter/i;function ao(i,e=En){let t=lt(i);return Array.from({length:t.length/2},(n,s)=>[t[2*s],t[2*s+1],e])}var mu=class{constructor(e,{head:t,meshes:n}){this.round=e;let{plan:s}=e;this.group.add(this.bodies);for(let{part:r,...o}of s.scene){let a=Bi(o,n),l=r==="obstacle",c=new st(a,Et(Fi(new On,1.015),l?"obstacle":"carrier"));c.receiveShadow=c.castShadow=!0,l&&this.obstacles.push(c);let h=new Vr(new da(a,30),Et(Fi(new Ds({transparent:!0,opacity:.4}),1.01),"obstacle-line"));this.bodies.add($t(c,o.pose)),this.group.add($t(h,o.pose))}this.addSurface(gE.test(t?.task?.surface??"")),this.addGoal(),s.strokes.forEach(r=>{let o=Et(new Xt({linewidth:6,transparent:!0,opacity:.35}),"stroke"),a=Fn(xs(gs(s.surface.shape,ao(r,2*En),!1),!1),o);this.strokes.push(a),this.strokeGroup.add(a)}),this.group.add($t(this.strokeGroup,s.surface.pose))}round;group=new ot;bodies=new ot;obstacles=[];sights=null;surface=null;outlines=new Map;strokes=[];strokeGroup=new ot;show(e,t,n,s){let{truth:r}=this.round,o=r?.surface??null,{shape:a}=this.round.plan.surface;for(let l of this.outlines.values())l.visible=!1;n&&e.found&&this.showOutline(n,()=>this.outlineAt(n,a,"found",.28)),o&&e.actual&&this.showOutline(o,()=>this.outlineAt(o,Qa(r,a),"actual",0)),this.strokeGroup.visible=e.strokes||s!==null,this.strokes.forEach((l,c)=>{l.visible=e.strokes||c===s,Et(l.material,c===s?"chosen":"stroke"),l.material.linewidth=c===s?7:c===t?9:6,l.material.opacity=c===s?1:c===t?.6:.35})}showOutline(e,t){let n=this.outlines.get(e);n||(n=t(),this.outlines.set(e,n),this.group.add(n)),n.visible=!0}fade(e){if(!(!this.surface||!this.obstacles.length)){this.sights??=this.makeSights(this.surface);for(let t of this.obstacles){let[n]=du([t]),s=n!==void 0&&this.sights.some(r=>gp(n,r,e));t.material.transparent=s,t.material.opacity=s?pE:1,t.material.depthWrite=t.castShadow=!s}}}get rings(){return this.round.plan.surface.rings.map(e=>ao(e)).filter(e=>e.length>=3)}face(){let e=this.round.plan.surface.shape;if(e?.kind==="mesh")return tl(e).geometry;let[t,...n]=this.rings.map(r=>r.map(([o,a])=>new te(o,a)));if(!t)return null;let s=new Li(t);return s.holes=n.map(r=>new Li(r)),cp(e,new zs(s))}makeSights(e){this.group.updateMatrixWorld(!0);let t=Qs([e]),n=fu(t);return[n,...t.map(s=>s.lerp(n,.1))].map(s=>s.clone().addScaledVector(ms(this.round.plan.surface,s),mE))}addSurface(e){let{pose:t,shape:n}=this.round.plan.surface,s=this.face();if(!s)return;let r=new On({side:hn,polygonOffset:!0,polygonOffsetFactor:-1,polygonOffsetUnits:-1});e&&!n&&(r.map=Vx()),this.surface=$t(new st(s,Et(r,e?"surface-3d":"sheet-3d")),t),this.surface.receiveShadow=!0,this.bodies.add(this.surface);let o=this.rings.flatMap(a=>xs(gs(n,a,!0),!0));this.group.add($t(Fn(o,Et(new Xt({linewidth:2}),"outline")),t))}outlineAt(e,t,n,s){let r=$t(new ot,e),o=Et(new Xt({linewidth:s?3:2}),n),a=this.rings.flatMap(c=>xs(gs(t,c.map(([h,u,d])=>[h,u,d+(s?1:2)*En]),!0),!0));r.add(Fn(s?a:cu(a,yp),o));let l=s?this.face():null;if(l){let c=new On({transparent:!0,opacity:s,depthWrite:!1});r.add(new st(l,Et(c,n)))}return r}addGoal(){let{goal:e,surface:t}=this.round.plan;if(e?.kind!=="collected")return;let[n,s]=e.place,r=$t(new ot,t.pose),o=(a,l,c)=>{let h=new On({transparent:!0,opacity:l,depthWrite:!1,polygonOffset:!0,polygonOffsetFactor:-3,polygonOffsetUnits:-3});a.translate(n,s,En),r.add(new st(cp(t.shape,a),Et(h,c)))};o(new ts(e.radius,48),.22,"goal"),o(new Bs(Math.max(0,e.radius-.003),e.radius,48),1,"goal-line"),o(new ts(Math.min(.006,.3*e.radius),24),1,"goal-line"),this.group.add(r)}};var Gx=.0015,Hx=4e3,xE=5,yE=.1,vE=11,Wx={none:0,contact:1,pushed:2},$x=()=>["lifted","contact","pushed"].map(i=>new Re(Me(i))),gu=class{constructor(e){this.round=e;this.ribbon=new su(Hx,e.target),this.object.add(this.lines.line,this.ribbon.mesh)}round;object=new ot;ribbon;lines=new oo(3,$x());times=[];taken=0;step=Gx;last=null;kind=Wx.none;basis="";show(e,t){this.grow();let n=li(this.times,e)+1;this.lines.show(t.path?n:0),this.ribbon.show(e,t.ribbon)}paint(){this.lines.paint($x()),this.ribbon.paint()}between(e,t){let n=[],{round:s}=this,r=Math.max(1,Math.floor(s.count/2e4)),o=null;for(let a=Math.max(0,s.place(e)[0]);a<s.count&&s.t[a]<=t;a+=r){let{place:l}=this.place(a);o&&n.push(...o.toArray(),...l.toArray()),o=l}return n}nearest(e,t,n,s,r,o){let[a,l]=[r**2,null];for(let c=0;c<this.times.length&&this.times[c]<=s;c++){if(o&&!this.round.isPressed(this.times[c]))continue;let h=e(this.lines.end(c)),u=(h.x-t)**2+(h.y-n)**2;u<=a&&([a,l]=[u,this.times[c]])}return l}place(e){let t=new E().fromArray(this.round.tool,7*e),n=ms(this.round.plan.surface,t);return{place:t.addScaledVector(n,1.5*En),normal:n}}press(e,{place:t,normal:n}){let{round:s,step:r}=this,o=s.height.data[e],a=Number.isFinite(o)?t.clone().addScaledVector(n,-o):t,l=s.target??Math.max(xE,s.normal.largest);this.ribbon.push(s.t[e],a,n,s.normal.data[e],{step:r,reference:l})}restart(){this.taken=0,this.last=null,this.lines.clear(),this.times.length=0,this.ribbon.clear()}grow(){let{round:e}=this;this.basis!==e.basis&&this.restart(),this.basis=e.basis;let t=e.over||e.interpreted?e.count:e.count-$h+1;for(;this.taken<t;){let n=this.taken++,s=e.t[n],r=this.place(n),{place:o}=r;if(!Number.isFinite(o.x+o.y+o.z))continue;e.isPressed(s)&&Number.isFinite(e.normal.data[n])?this.press(n,r):this.ribbon.breakOff();let a=Wx[e.contactAt(s)];this.last&&this.last.distanceToSquared(o)<this.step**2&&(a===this.kind||this.step>2*Gx)||(this.last&&(this.lines.push([...this.last.toArray(),...o.toArray()],a),this.times.push(s)),this.last=o,this.kind=a,this.lines.count>Hx&&(this.step*=2,this.restart()))}}},bE=6,vp=i=>`track-${i%bE+1}`,Xx=i=>i.flatMap(({points:e,samples:t,color:n},s)=>{let r=new Xt({linewidth:4.5,transparent:!0,polygonOffset:!0,polygonOffsetFactor:-12,polygonOffsetUnits:-12});r.color.set(xu(n,s));let o=Fn(xs(e,!1),r);return o.renderOrder=6,t?.length?[o,Yx(t,xu(n,s))]:[o]}),qx=i=>i.flatMap(({pose:e,color:t})=>{let n=At(e),s=new E().setFromMatrixPosition(n).toArray();return[...["axis-x","axis-y","axis-z"].map((o,a)=>{let l=new E().setComponent(a,yE).applyMatrix4(n).toArray();return Fn([...s,...l],Et(new Xt({linewidth:3.5}),o))}),Yx([s],Gi(t,Me("axis-z")))]});function Yx(i,e){let t=ps(i.flat(),tu(),vE);return t.material.color.set(e),t}var Gi=(i,e)=>i&&/^#[0-9a-f]{3,8}$/i.test(i)?i:e,xu=(i,e)=>Gi(i,Me(vp(e)));var vs=400,er=220,[lo,bp,_p,rl]=[52,12,10,38],bi=27,yu=130,Zx=20,_E=21;function jx(i,e){let t=a=>a?.map(([l,c])=>[e(l),c]),n={...i,amounts:t(i.amounts),spans:t(i.spans)},s=n.title||n.id||n.diagram,r=n.amounts?n.diagram==="piechart"?SE(n.amounts):ME(n.amounts):n.spans?TE(n.spans):EE(n);r.setAttribute("role","img"),r.setAttribute("aria-label",`${n.diagram}: ${s}`);let o=[n.x_label,n.y_label].filter(a=>a);return M("figure",{class:"s-plot"},M("figcaption",{},s),r,o.length?M("p",{class:"w-quiet"},o.join(" / ")):null)}var bs=i=>Number.isInteger(i)?Be(i,0):Be(i,Math.abs(i)<10?3:1),al=(i,...e)=>ie("svg",{viewBox:`0 0 ${vs} ${i}`},...e),Kx=(i,e,t,n="end")=>{let[s="",r]=t.split(`
`);if(!r)return[Zt(i,e,ol(s,Zx),n)];let o=Zt(i,e+6,ol(r,_E),n,{fill:"var(--quiet)","font-size":9.5});return[Zt(i,e-5,ol(s,Zx),n),o]},wE=i=>i.replace(`
`,", "),ol=(i,e)=>i.length>e?`${i.slice(0,e-1)}\u2026`:i;function Jx(i,[e,t],n,s){let r=o=>yu+(vs-yu-n)*(o-e)/(t-e||1);return i.flatMap(({name:o,from:a,to:l,value:c,label:h},u)=>[...Kx(yu-6,u*bi+17,o),ie("rect",{x:r(a),y:u*bi+4,width:Math.max(1,r(l)-r(a)),height:bi-6,rx:3,fill:`var(--${s})`},ie("title",{},`${wE(o)}: ${c}`)),...h===void 0?[]:[Zt(r(l)+5,u*bi+17,h)]])}function ME(i){let e=i.map(([,n])=>n),t=i.map(([n,s])=>({name:n,from:Math.min(0,s),to:Math.max(0,s),value:String(s),label:bs(s)}));return al(t.length*bi+6,...Jx(t,[Math.min(0,...e),Math.max(0,...e)],52,"believed"))}function SE(i){let e=i.reduce((l,[,c])=>l+c,0)||1,[t,n,s]=[90,92,82],r=-Math.PI/2,o=l=>`${t+s*Math.cos(l)} ${n+s*Math.sin(l)}`,a=Math.max(2*n,i.length*bi+10);return al(a,...i.flatMap(([l,c],h)=>{let u=r;r+=2*Math.PI*c/e;let d=`var(--${vp(h)})`;return[c>=e?ie("circle",{cx:t,cy:n,r:s,fill:d}):ie("path",{d:`M${t} ${n}L${o(u)}A${s} ${s} 0 ${r-u>Math.PI?1:0} 1 ${o(r)}Z`,fill:d,stroke:"var(--paper)"}),ie("rect",{x:190,y:h*bi+4,width:12,height:12,fill:d}),...Kx(208,h*bi+14,l,"start"),Zt(vs-4,h*bi+14,`${bs(c)} (${Be(100*c/e,0)} %)`,"end")]}))}function TE(i){let e=[Math.min(...i.map(([,[s]])=>s)),Math.max(...i.map(([,[,s]])=>s))],t=i.map(([s,[r,o]])=>({name:s,from:r,to:o,value:`${bs(o-r)} s`})),n=t.length*bi+22;return al(n,...Jx(t,e,10,"event"),Zt(yu,n-4,"0 s"),Zt(vs-10,n-4,`${bs(e[1]-e[0])} s`,"end"))}function EE({points:i=[],diagram:e,x_label:t,y_label:n}){let s=d=>{let f=i.map(g=>g[d]),[p,x]=[Math.min(...f),Math.max(...f)];return p<x?[p,x]:[p-.5,x+.5]};if(!i.length)return al(30,Zt(8,18,"no points"));let[[r,o],[a,l]]=[s(0),s(1)],c=d=>lo+(vs-lo-bp)*(d-r)/(o-r),h=d=>er-rl-(er-_p-rl)*(d-a)/(l-a),u=e==="linechart"?[ie("path",{d:i.map(([d,f],p)=>`${p?"L":"M"}${c(d).toFixed(1)} ${h(f).toFixed(1)}`).join(""),fill:"none",stroke:"var(--believed)","stroke-width":1.8})]:i.map(([d,f])=>ie("circle",{cx:c(d),cy:h(f),r:2.6,fill:"var(--believed)","fill-opacity":.7}));return al(er,ie("path",{d:`M${lo} ${_p}V${er-rl}H${vs-bp}`,fill:"none",stroke:"var(--rule)"}),...u,Zt(lo-5,h(a),bs(a),"end"),Zt(lo-5,h(l)+9,bs(l),"end"),Zt(lo,er-rl+15,bs(r)),Zt(vs-bp,er-rl+15,bs(o),"end"),Zt(vs/2,er-5,ol(t,40),"middle"),Zt(4,_p+22,ol(n,30)))}var wp=class{constructor(e){this.host=e}host;steps=new Map;draws=new Set;drawn=null;asked=!1;last=0;request(e){return this.steps.set(++this.last,e),this.ask(),this.last}now(){return performance.now()}cancel(e){this.steps.delete(e)}draw(e){this.draws.add(e),this.ask()}drop(e){this.draws.delete(e)}ask(){this.asked||this.drawn||(this.asked=!0,this.host(e=>this.run(e)))}run(e){this.asked=!1;let t=this.drawn=new Set,n=this.steps;this.steps=new Map;for(let s of n.values())Qx(()=>s(e));for(let s=this.next(t);s;s=this.next(t))this.draws.delete(s),t.add(s),Qx(s);this.drawn=null,(this.steps.size||this.draws.size)&&this.ask()}next(e){for(let t of this.draws)if(!e.has(t))return t;return null}};function co(i,e){let t=-1/0,n,s=()=>{n=void 0,t=performance.now(),e()};return{ask:()=>{if(n!==void 0)return;let r=t+i-performance.now();r<=0?s():n=setTimeout(s,r)},stop:()=>clearTimeout(n)}}function vu(i,e){let t=i.onChange(n=>{n?.piece!=="samples"&&An.draw(e)});return()=>{t(),An.drop(e)}}function Qx(i){try{i()}catch(e){reportError(e)}}var An=new wp(i=>requestAnimationFrame(i));var AE=13,Mp=i=>new Path2D(`M32 ${32-i}l${i} ${i}l${-i} ${i}l${-i} ${-i}z`),RE=i=>js(e=>{e.fillStyle="#000",e.fill(Mp(31)),e.fillStyle="#fff",e.fill(Mp(24)),i&&(e.globalCompositeOperation="destination-out",e.fill(Mp(13)))}),Sp=i=>Gi(i,Me("highlight"));function ey(i){return i.map(({color:e,pose:t,shape:n,places:s,state:r},o)=>{let a=s.flatMap(([c,h])=>ri(n,c,h,2*En)),l=$t(ps(a,RE(r==="estimated"),AE,{renderOrder:7+o/(i.length+1)}),t);return l.material.color.set(Sp(e)),l})}var ty={type:"change"},Ep={type:"start"},iy={type:"end"},bu=new fi,ny=new Ln,CE=Math.cos(70*Qr.DEG2RAD),Ft=new E,Rn=2*Math.PI,ut={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Tp=1e-6,_u=class extends ka{constructor(e,t=null){super(e,t),this.state=ut.NONE,this.target=new E,this.cursor=new E,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:as.ROTATE,MIDDLE:as.DOLLY,RIGHT:as.PAN},this.touches={ONE:ls.ROTATE,TWO:ls.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new E,this._lastQuaternion=new Rt,this._lastTargetPosition=new E,this._quat=new Rt().setFromUnitVectors(e.up,new E(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new qr,this._sphericalDelta=new qr,this._scale=1,this._panOffset=new E,this._rotateStart=new te,this._rotateEnd=new te,this._rotateDelta=new te,this._panStart=new te,this._panEnd=new te,this._panDelta=new te,this._dollyStart=new te,this._dollyEnd=new te,this._dollyDelta=new te,this._dollyDirection=new E,this._mouse=new te,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=IE.bind(this),this._onPointerDown=PE.bind(this),this._onPointerUp=LE.bind(this),this._onContextMenu=BE.bind(this),this._onMouseWheel=kE.bind(this),this._onKeyDown=OE.bind(this),this._onTouchStart=UE.bind(this),this._onTouchMove=FE.bind(this),this._onMouseDown=DE.bind(this),this._onMouseMove=NE.bind(this),this._interceptControlDown=zE.bind(this),this._interceptControlUp=VE.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=ut.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(ty),this.update(),this.state=ut.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;Ft.copy(t).sub(this.target),Ft.applyQuaternion(this._quat),this._spherical.setFromVector3(Ft),this.autoRotate&&this.state===ut.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=Rn:n>Math.PI&&(n-=Rn),s<-Math.PI?s+=Rn:s>Math.PI&&(s-=Rn),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Ft.setFromSpherical(this._spherical),Ft.applyQuaternion(this._quatInverse),t.copy(this.target).add(Ft),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Ft.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new E(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new E(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Ft.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(bu.origin.copy(this.object.position),bu.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(bu.direction))<CE?this.object.lookAt(this.target):(ny.setFromNormalAndCoplanarPoint(this.object.up,this.target),bu.intersectPlane(ny,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Tp||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Tp||this._lastTargetPosition.distanceToSquared(this.target)>Tp?(this.dispatchEvent(ty),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?Rn/60*this.autoRotateSpeed*e:Rn/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){Ft.setFromMatrixColumn(t,0),Ft.multiplyScalar(-e),this._panOffset.add(Ft)}_panUp(e,t){this.screenSpacePanning===!0?Ft.setFromMatrixColumn(t,1):(Ft.setFromMatrixColumn(t,0),Ft.crossVectors(this.object.up,Ft)),Ft.multiplyScalar(e),this._panOffset.add(Ft)}_pan(e,t){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Ft.copy(s).sub(this.target);let r=Ft.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/n.clientHeight,this.object.matrix),this._panUp(2*t*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=e-n.left,r=t-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Rn*this._rotateDelta.x/t.clientHeight),this._rotateUp(Rn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(Rn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-Rn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(Rn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-Rn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(n,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let n=this._getSecondPointerPosition(e),s=.5*(e.pageX+n.x),r=.5*(e.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Rn*this._rotateDelta.x/t.clientHeight),this._rotateUp(Rn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new te,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function PE(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function IE(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function LE(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(iy),this.state=ut.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function DE(i){let e;switch(i.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case as.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=ut.DOLLY;break;case as.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=ut.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=ut.ROTATE}break;case as.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=ut.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=ut.PAN}break;default:this.state=ut.NONE}this.state!==ut.NONE&&this.dispatchEvent(Ep)}function NE(i){switch(this.state){case ut.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case ut.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case ut.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function kE(i){this.enabled===!1||this.enableZoom===!1||this.state!==ut.NONE||(i.preventDefault(),this.dispatchEvent(Ep),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(iy))}function OE(i){this.enabled!==!1&&this._handleKeyDown(i)}function UE(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case ls.ROTATE:if(this.enableRotate===!1){this.state=ut.NONE;break}this._handleTouchStartRotate(i),this.state=ut.TOUCH_ROTATE;break;case ls.PAN:if(this.enablePan===!1){this.state=ut.NONE;break}this._handleTouchStartPan(i),this.state=ut.TOUCH_PAN;break;default:this.state=ut.NONE}break;case 2:switch(this.touches.TWO){case ls.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=ut.TOUCH_DOLLY_PAN;break;case ls.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=ut.TOUCH_DOLLY_ROTATE;break;default:this.state=ut.NONE}break;default:this.state=ut.NONE}this.state!==ut.NONE&&this.dispatchEvent(Ep)}function FE(i){switch(this._trackPointer(i),this.state){case ut.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case ut.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case ut.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case ut.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=ut.NONE}}function BE(i){this.enabled!==!1&&i.preventDefault()}function zE(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function VE(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var wu=Math.PI/24,GE=380,Mu=class{constructor(e,t,n){this.taken=n;this.lens.up.set(0,0,1),this.controls=new _u(this.lens,e),this.controls.maxPolarAngle=.62*Math.PI,this.controls.minDistance=.1,this.controls.maxDistance=40,this.controls.zoomToCursor=!0,this.controls.addEventListener("start",()=>{this.held=!0}),this.controls.addEventListener("end",()=>{this.held=!1}),this.controls.addEventListener("change",()=>{this.held&&this.take(),t()}),e.addEventListener("wheel",s=>{let{scrollHeight:r,clientHeight:o}=document.documentElement;this.controls.enableZoom=s.ctrlKey||document.activeElement===e||r<=o+1},{capture:!0,passive:!0}),e.addEventListener("pointerdown",()=>{this.controls.enableZoom=!0,e.focus({preventScroll:!0})},!0),e.addEventListener("keydown",s=>{if(s.ctrlKey||s.metaKey||s.altKey)return;let r={a:[-wu,0],d:[wu,0],w:[0,-wu],s:[0,wu]},o={z:1/1.15,x:1.15},[a,l]=[r[s.key],o[s.key]];if(a)this.turn(...a);else if(l)this.zoom(l);else return;s.preventDefault(),s.stopPropagation()})}taken;lens=new pn(36,1,.02,200);controls;open=1;goal=null;stepped=0;asked=!1;held=!1;get angles(){let e=Math.tan(this.lens.fov*Math.PI/360);return{high:e,wide:e*this.lens.aspect*this.open}}look(e,t=!1){if(e){if(this.goal=t&&!matchMedia("(prefers-reduced-motion: reduce)").matches?e:null,this.stepped=performance.now(),this.asked=t,!this.goal)return this.move(e);this.controls.dispatchEvent({type:"change"})}}step(){if(!this.goal)return!1;let e=performance.now(),t=1-Math.exp((this.stepped-e)/GE);this.stepped=e;let{goal:n}=this,s=this.controls.target.clone().lerp(n.target,t),r=this.lens.position.clone().lerp(n.eye,t);return r.distanceTo(n.eye)+s.distanceTo(n.target)<.002*r.distanceTo(s)&&(this.goal=null),this.move(this.goal?{target:s,eye:r}:n),this.goal!==null}followLinked(e,t){t&&this.take(),this.goal=null,this.move(e)}get view(){return{target:this.controls.target.clone(),eye:this.lens.position.clone()}}pixelsPerMetre(e,t){let n=e?new E().setFromMatrixPosition(e.matrix):this.controls.target;return t/(2*Math.tan(this.lens.fov*Math.PI/360)*Math.max(.05,n.distanceTo(this.lens.position)))}shape(e,t,n){this.lens.aspect=e/t,this.open=(e-n)/e,this.lens.setViewOffset(e,t,-n/2,0,e,t)}move({target:e,eye:t}){let{held:n}=this;this.held=!1,this.controls.target.copy(e),this.lens.position.copy(t),this.controls.update(),this.held=n}take(){this.goal=null,this.asked=!0,this.taken()}turn(e,t){this.take();let n=this.lens.position.clone().sub(this.controls.target);n.applyAxisAngle(new E(0,0,1),e);let s=new E().crossVectors(this.lens.up,n).normalize(),r=n.clone().applyAxisAngle(s,t),o=r.angleTo(this.lens.up),{target:a}=this.controls;this.move({target:a,eye:a.clone().add(o>.02&&o<this.controls.maxPolarAngle?r:n)})}zoom(e){this.take();let{target:t,eye:n}=this.view;this.move({target:t,eye:t.clone().lerp(n,e)})}};var Ip=.007,HE=600,WE=5.5,$E=18,XE=.03,Ap=1500,qE=1.7,YE=.6,ZE=.35,Su=.4,NL=Su+.32*(1-Su),Cp=["position","normal"],ho=(i,e)=>i.getAttribute(e);function ry(i){return/crumb|chip|sand|gravel|debris/i.test(i??"")?"crumb":/water|detergent|soap|juice|milk/i.test(i??"")?"drop":null}function Pp(i,e){let t=Math.sin(12.9898*i+78.233*e)*43758.5453;return t-Math.floor(t)}var Rp=(i,e,t,n)=>new Di(1,i,e,0,2*Math.PI,0,t*Math.PI).rotateX(Math.PI/2).translate(0,0,-Math.cos(t*Math.PI)).scale(1,1,n);function sy(i){let e=ho(i,"position");for(let t=0;t<e.count;t++){let n=1-ZE*Pp(Math.round(20*e.getX(t)),Math.round(20*e.getY(t))+Math.round(20*e.getZ(t)));e.setXYZ(t,n*e.getX(t),n*e.getY(t),n*e.getZ(t))}return i.deleteAttribute("normal")}function jE(){let i=new ts(qE,8),{count:e}=i.getAttribute("position");return i.setAttribute("color",new ct(Float32Array.from({length:4*e},(t,n)=>n===3?YE:0),4)),i.deleteAttribute("normal")}var Tu=class{mesh;shape=null;capacity=0;constructor(e){this.mesh=new st(new We,e),this.mesh.frustumCulled=!1}place(e,t,n,s){let r=t.length/2;(this.shape!==e||this.capacity<r)&&this.reserve(e,2*r);let{geometry:o}=this.mesh;for(let a=0;a<r;a++)KE(o,e,a,n,s,t[2*a],t[2*a+1]);for(let a of Cp)o.hasAttribute(a)&&(ho(o,a).needsUpdate=!0);o.setDrawRange(0,r*e.index.count)}reserve(e,t){this.mesh.geometry.dispose();let n=new We,[s,r]=[ho(e,"position").count,e.index];for(let o of[...Cp,"color"].filter(a=>e.hasAttribute(a))){let{array:a,itemSize:l}=ho(e,o);n.setAttribute(o,new ct(Float32Array.from({length:a.length*t},(c,h)=>a[h%a.length]),l))}n.setIndex(new ct(Uint32Array.from({length:r.count*t},(o,a)=>r.array[a%r.count]+s*Math.floor(a/r.count)),1)),this.mesh.geometry=n,[this.shape,this.capacity]=[e,t]}},Eu=class{group=new ot;few;many;shadow=jE();grains;shadows=new Tu(new cn({vertexColors:!0,transparent:!0,depthWrite:!1,polygonOffset:!0,polygonOffsetFactor:-2,polygonOffsetUnits:-2}));drawn={places:null,radius:0};constructor(e){[this.few,this.many]=e==="crumb"?[sy(Rp(5,3,.62,.85)),sy(new Os(1,1,4,1,!0).rotateX(Math.PI/2).translate(0,0,.5))]:[Rp(8,3,.5,.55),Rp(6,2,.5,.55)],this.grains=new Tu(new Ta(e==="crumb"?{flatShading:!0,specular:6710886,shininess:8}:{specular:10066329,shininess:60})),this.group.add(this.grains.mesh,this.shadows.mesh),this.paint()}paint(){let{color:e,emissive:t}=this.grains.mesh.material;e.set(Me("believed")),t.copy(e).multiplyScalar(Su),e.multiplyScalar(1-Su)}show(e,t,n,s){if(this.group.visible=e!==null&&e.length>0,!e||!this.group.visible)return;$t(this.group,t);let r=e.length/2,o=Ip*Math.min(1,Math.sqrt(HE/r)),a=Math.min($E/s,Math.max(WE/s,o))/2;this.drawn.places===e&&Math.abs(a/this.drawn.radius-1)<XE||(this.drawn={places:e,radius:a},this.grains.place(r<Ap?this.few:this.many,e,a,n),this.shadows.mesh.visible=r<Ap,r<Ap&&this.shadows.place(this.shadow,e,a,n))}};function KE(i,e,t,n,s,r,o){let[a,l,c]=ri(s,r,o,0),[h,u,d]=s?ri(s,r,o,1):[a,l,c+1],[f,p,x]=[h-a,u-l,d-c],g=2*Math.PI*Pp(r,o),m=n*(.75+.5*Pp(o,r)),[y,S]=[Math.cos(g),Math.sin(g)],b=y*f+S*p,A=Math.sqrt(1-Math.min(.99,b*b)),[R,v,T]=[(y-b*f)/A,(S-b*p)/A,-b*x/A],[D,P,k]=[p*T-x*v,x*R-f*T,f*v-p*R];for(let O of Cp){if(!e.hasAttribute(O))continue;let[z,I,H,X]=O==="position"?[m,a,l,c]:[1,0,0,0],[G,ne]=[ho(e,O).array,ho(i,O).array];for(let $=0,J=t*G.length;$<G.length;$+=3,J+=3){let[ee,we,ke]=[z*G[$],z*G[$+1],z*G[$+2]];ne[J]=I+ee*R+we*D+ke*f,ne[J+1]=H+ee*v+we*P+ke*p,ne[J+2]=X+ee*T+we*k+ke*x}}}var bn=({plan:{goal:i}})=>i?.kind==="polished"||i?.kind==="dispensed",_i=({plan:{goal:i}})=>i?.kind==="dispensed"?"coat thickness":"passes",ll=.51,tr={little:"too little",allowed:"allowed",much:"too much"},Au={little:4,allowed:3,much:2};function oy(i,e,t,n){let s=n?Math.min(t,e-i):t,r=Array.from({length:s},(o,a)=>i+(e-i)*a/s);return n?r.map(Math.floor):r}function _s({unit:i,low:e,high:t,target:n}){let s=i==="passes",r=s?t+1:t,o={little:oy(0,e,Au.little,s),allowed:oy(e,r,Au.allowed,s),much:[r,s?r+Math.max(1,t-e):t+2*(t-n)]},a=(h,u,d)=>{let[f,p]=[h==="little"&&d<Au.little?2:1,Au[h]];return f+Math.round(u*(p-f)/Math.max(1,d-1))},l=Object.keys(o).flatMap(h=>o[h].map((u,d,{length:f})=>({degree:h,from:u,colour:`${h}-${a(h,d,f)}`}))),c=h=>String(s?h:Number(h.toPrecision(h<100?2:3)));return l.map((h,u)=>{let d=l[u+1]?.from,f=d===void 0?null:s?d-1:d;return{...h,label:f===null?`\u2265 ${c(h.from)}`:f===h.from?c(f):`${c(h.from)}\u2013${c(f)}`}})}function ws(i,{unit:e,target:t},n){let s=e==="passes"?Math.round(n):n,r=1e-6*t,o=0;return i.forEach(({degree:a,from:l},c)=>{(a==="much"&&e!=="passes"?s>l+r:s>=l-r)&&(o=c)}),o}function cl(i,e){let t=_s(i);return e.map(n=>t[ws(t,i,n)].degree)}var hl=(i,e)=>i.filter(t=>t===e).length/Math.max(1,i.length),ly=({unit:i,low:e,high:t})=>e===t?`${e} ${i}`:`${e} to ${t} ${i}`,ay=new WeakMap;function vn(i,e){if(!i||!e||e.length!==i.places.length/2)return null;let t=ay.get(e);if(t)return t;let n=e.map(s=>ci(s)*i.step);return ay.set(e,n),n}function Ru(i,e,t,n){let s=i.endedAt(e);if(s?.plan.treatment){let{interpreted:a,truth:l,plan:{treatment:c,surface:h}}=s,u=a?.found??h.pose,d=`${_i(s)} after round ${s.number}`,f=n.actual?vn(c,l?.treated):null;if(f)return{kind:"true",title:`True ${d}`,record:c,values:f,pose:l?.surface??u,shape:Qa(l,h.shape)};let p=n.estimated?vn(c,a?.treated):null;if(p)return{kind:"estimated",title:`Estimated ${d}: mean of the belief`,record:c,values:p,pose:u,shape:h.shape}}let{treatment:r,surface:o}=t.plan;return!n.believed||!r||!t.treated?null:{kind:"predicted",title:`Predicted ${_i(t)}`,record:r,values:t.treated.at(e-t.start),pose:o.pose,shape:o.shape}}var Lp=["believed","estimated","actual","seen"],Dp={believed:6,estimated:12,actual:8,seen:14},JE={believed:i=>{i.arc(32,32,28,0,2*Math.PI),i.fill()},estimated:i=>{i.lineWidth=9,i.arc(32,32,25,0,2*Math.PI),i.stroke()},actual:i=>{i.lineWidth=15,i.moveTo(10,10),i.lineTo(54,54),i.moveTo(54,10),i.lineTo(10,54),i.stroke()},seen:i=>{i.lineWidth=7,i.rect(6,6,52,52),i.stroke()}},Cu=class{group=new ot;points;shown=new Map;grains=null;outcome={key:"",outcome:null};constructor(){this.points=Object.fromEntries(Lp.map(e=>{let t=ps([],js(JE[e]),Dp[e],{nearer:.99,alphaTest:.15,renderOrder:2+Lp.indexOf(e)});return Et(t.material,e),this.group.add(t),[e,t]}))}paint(){this.grains?.paint()}show(e,t,{round:n,time:s},r,o){let a=Math.min(1.25,Math.max(.7,Ip*o/Dp.believed));for(let m of Lp)this.points[m].material.size=a*Dp[m];let l=`${e.version} ${e.rounds.filter(m=>m.end<=t+1e-6).length}`;l!==this.outcome.key&&(this.outcome={key:l,outcome:e.outcomeAt(t)});let{outcome:c}=this.outcome,{pose:h,shape:u}=n.plan.surface,d=!bn(n),f=d&&r.believed?n.particles.at(s):null,p=ry(e.head?.task?.medium);p&&!this.grains&&(this.grains=new Eu(p),this.group.add(this.grains.group)),this.grains?.show(f,h,u,o),this.set("believed",this.grains?null:f,h,u,1);let x=c?.pose??h,g=e.endedAt(t)||t<n.start+n.firstContact?1:.45;this.set("estimated",d&&r.estimated?c?.estimated??null:null,x,c?.shape,g),this.set("actual",d&&r.actual?c?.actual??null:null,c?.actualPose??x,c?.actualShape,g),this.set("seen",r.seen?c?.seen??null:null,x,c?.shape,g)}set(e,t,n,s,r){let o=this.points[e];if(o.visible=t!==null&&t.length>0,!t||!o.visible||($t(o,n),o.material.opacity=r,this.shown.get(e)===t))return;this.shown.set(e,t);let a=Array.from({length:t.length/2},(l,c)=>ri(s,t[2*c],t[2*c+1],En));o.geometry.dispose(),o.geometry.setAttribute("position",new Ne(a.flat(),3))}};var QE=.11,eA=.0042,cy=.5,tA=new E(0,1,0),Pu=class{group=new ot;shaft;tip;constructor(e,t){let n=Et(new cn({depthTest:!1,transparent:!0,opacity:.95}),t);this.shaft=new st(new ns(e,e,1,12).translate(0,.5,0),n),this.tip=new st(new Os(3*e,6*e,16).translate(0,3*e,0),n),this.group.add(this.shaft,this.tip),this.group.renderOrder=this.shaft.renderOrder=this.tip.renderOrder=8}show(e,t,n){let s=t.length();this.group.visible=s>.001,this.group.visible&&(this.group.position.copy(e),this.group.quaternion.setFromUnitVectors(tA,t.clone().divideScalar(s)),this.shaft.scale.set(n,s,n),this.tip.position.y=s,this.tip.scale.setScalar(Math.min(n,s/9)))}},Iu=class{group=new ot;whole=new Pu(1,"force");pressed=new Pu(.5,"ink");constructor(){this.group.add(this.whole.group,this.pressed.group)}show(e,t,n,s){let{force:r,normal:o,round:a}=e,l=r?Math.hypot(...r):0;if(this.group.visible=s&&l>cy,!this.group.visible||!r)return;let c=QE/Math.max(10,a.normal.largest,l),h=eA*n.distanceTo(t);this.whole.show(t,new E(...r).multiplyScalar(c),h);let u=ms(a.plan.surface,t);this.pressed.show(t,u.multiplyScalar(Math.abs(o??0)>cy?(o??0)*c:0),h)}};var nA=[[-1,-1],[1,-1],[1,1],[-1,1]];function iA({record:i,shape:e}){let t=lt(i.places),[n,s]=i.cell.map(c=>ll*c),r=t.length/2,o=new Float32Array(12*r),a=[];for(let c=0;c<r;c++)nA.forEach(([h,u],d)=>o.set(ri(e,t[2*c]+h*n,t[2*c+1]+u*s,En/2),12*c+3*d)),a.push(4*c,4*c+1,4*c+2,4*c,4*c+2,4*c+3);let l=new We;return l.setAttribute("position",new ct(o,3)),l.setAttribute("color",new ct(new Float32Array(12*r),3)),l.setIndex(a),l}var Lu=class{mesh=new st(new We,Fi(new cn({vertexColors:!0,side:hn,toneMapped:!1,polygonOffset:!0,polygonOffsetFactor:-1,polygonOffsetUnits:-1}),.997));shown=null;theme="";constructor(){this.mesh.frustumCulled=!1}show(e,t){if(this.mesh.visible=e!==null,!e)return;$t(this.mesh,e.pose);let n=this.shown?.record===e.record&&this.shown.shape===e.shape;n||(this.mesh.geometry.dispose(),this.mesh.geometry=iA(e)),(!n||this.shown?.values!==e.values||this.theme!==t)&&this.paint(e),this.shown=e,this.theme=t}paint({record:e,values:t}){let n=_s(e),s=n.map(o=>new Re(Me(o.colour))),r=this.mesh.geometry.getAttribute("color");t.forEach((o,a)=>{let{r:l,g:c,b:h}=s[ws(n,e,o)];for(let u=0;u<4;u++)r.setXYZ(4*a+u,l,c,h)}),r.needsUpdate=!0}};function sA({mark:i,places:e},t){let[n,s]=[t.toFixed(1),(2*t).toFixed(1)],r={believed:"h0",estimated:`m-${n} 0a${n} ${n} 0 1 0 ${s} 0a${n} ${n} 0 1 0 -${s} 0`,actual:`m-${n} -${n}l${s} ${s}m0 -${s}l-${s} ${s}`,seen:`m-${n} -${n}h${s}v${s}h-${s}z`}[i],o="";for(let a=0;a+1<e.length;a+=2){let[l,c]=[1e3*e[a],-1e3*e[a+1]];Number.isFinite(l+c)&&(o+=`M${l.toFixed(1)} ${c.toFixed(1)}${r}`)}return ie("path",{d:o,class:`w-dots w-dots-${i}`,"stroke-width":i==="believed"?2.2*t:.7*t})}var Du=i=>Array.from({length:i.length/2},(e,t)=>`${t?"L":"M"}${(1e3*i[2*t]).toFixed(1)} ${(-1e3*i[2*t+1]).toFixed(1)}`).join(""),uo=({plan:{surface:i}})=>i.shape?"the unrolled surface":"the surface from above",nr=(i,e,t={})=>M("figure",t,i,M("figcaption",{},e));function Hi(i,e,t,n=null){let s=i.plan.surface.rings.map(m=>lt(m)).filter(m=>m.length>=6),{goal:r}=i.plan,o=m=>Array.from({length:m.length/2},(y,S)=>new te(m[2*S],m[2*S+1])),a=new Vs().setFromPoints(s.flatMap(o));if(r?.kind==="collected")for(let m of[-1,1])a.expandByPoint(new te(...r.place).addScalar(m*r.radius));let l=m=>Math.max(...m.getSize(new te)),c=a.clone().expandByScalar(s.length?.15*l(a):1/0);for(let{places:m}of e)for(let y of o(m))(!s.length||c.containsPoint(y))&&a.expandByPoint(y);a.max.x>a.min.x||a.set(new te,new te(1,1));let h=l(a),{min:u,max:d}=a.expandByScalar(.03*h),f=[u.x,-d.y,d.x-u.x,d.y-u.y].map(m=>(1e3*m).toFixed(1)),p=Math.max(1,...e.map(({places:m})=>m.length/2)),x=7*h*Math.min(1,Math.max(.6,Math.sqrt(160/p))),g=s.map(m=>`${Du(m)}Z`).join("");return ie("svg",{viewBox:f.join(" "),class:"w-picture",role:"img","aria-label":t},ie("path",{d:g,class:"w-ground","fill-rule":"evenodd","stroke-width":5*h}),n&&ie("clipPath",{id:n.id},ie("path",{d:g,"clip-rule":"evenodd"})),n?.map,r?.kind==="collected"&&ie("circle",{cx:1e3*r.place[0],cy:-1e3*r.place[1],r:1e3*r.radius,class:"w-goal","stroke-width":4*h}),...e.map(m=>sA(m,x)))}function dl(i){let e=_s(i),t=n=>{let s=e.filter(r=>r.degree===n);return s.length>0&&M("li",{"data-degree":n,style:`flex-grow:${s.length}`},M("span",{},tr[n]),ar(s))};return M("div",{class:"w-scale"},M("ul",{"aria-label":`Scale in ${i.unit}`},...Object.keys(tr).map(t)),M("p",{},`${i.unit}; allowed: ${ly(i)}${i.unit==="passes"?", counted in whole passes":`, target ${i.target} ${i.unit}`}`))}function rA(i,e){let t=cl(i,e);return Object.keys(tr).map(n=>`${_e(hl(t,n),1)} ${tr[n]}`).join(", ")}function Nu(i,e){let t=_s(i),n=t.map(()=>""),s=lt(i.places),[r,o]=i.cell.map(h=>1e3*h),[a,l]=[ll*r,ll*o],c=e.length;for(let h=0;h<c;){let u=ws(t,i,e[h]),[d,f]=[1e3*s[2*h],-1e3*s[2*h+1]],p=1,x=g=>h+g<c&&Math.abs(-1e3*s[2*(h+g)+1]-f)<.1*o&&Math.abs(1e3*s[2*(h+g)]-d-g*r)<.1*r;for(;x(p)&&ws(t,i,e[h+p])===u;)p++;n[u]+=`M${(d-a).toFixed(1)} ${(f-l).toFixed(1)}H${(d+(p-1)*r+a).toFixed(1)}V${(f+l).toFixed(1)}H${(d-a).toFixed(1)}z`,h+=p}return t.map(({colour:h},u)=>ie("path",{d:n[u],style:`fill:var(--${h})`}))}function ul(i,e,t){let n=e.plan.treatment;if(!n||!t)return null;let s=ai(),r=`${i}: ${_i(e)} per place; ${rA(n,t)} of ${t.length} places`,o=ie("g",{"clip-path":`url(#${s})`,class:"w-map"},...Nu(n,t));return nr(Hi(e,[],r,{id:s,map:o}),i)}function hy({rounds:i},e){let t=i[0],n=i.at(-1),s=i.findLast(h=>h.interpreted)??null,r=t.plan.surface.shape?", surface unrolled":"",o=n.plan.treatment;if(!o){let h=`This recording has no ${_i(n)} per place.`;return[nr(Hi(n,[],h),h,{class:"w-wide"})]}let a=[ul("Before",t,t.treated?.first??null),ul(n.number===1?"Predicted":`Predicted for round ${n.number}`,n,n.treated?.last??null),e??(s&&ul(`Estimated after ${s.number} ${s.number===1?"round":"rounds"}: mean of the belief`,s,vn(s.plan.treatment,s.interpreted?.treated)))].filter(h=>h!==null),l=_i(n),c=`${Yi(l)} per place${r}`;return[M("p",{class:"w-wide w-quiet"},c),...a,dl(o)]}var Wi=5e-4,Np=700,kp=({plan:i},e)=>i.without?.find(t=>t.stroke===e)??null,ku=i=>i.plan.predicted??i.growthAt(1/0)??NaN;function uy(i){let{phases:e,growth:t,strokes:n}=i.plan;if(!t.length)return[];let s=0,r=i.growthAt(0);return e.filter(({stroke:o})=>typeof o=="number"&&n[o]).map(({start:o,end:a,stroke:l})=>{let c=i.growthAt(a),h=kp(i,l),u={stroke:l,gain:c-r,marginal:h&&ku(i)-h.performance,way:oA(lt(n[l]??[])),start:o,time:a-s};return[s,r]=[a,c],u})}var oA=i=>{let e=0;for(let t=2;t+1<i.length;t+=2)e+=Math.hypot(i[t]-i[t-2],i[t+1]-i[t-1]);return e},dy=(i,e,t,n)=>i===0?`as many ${t} ${n}`:`${Math.abs(i)} ${i>0?"more":"fewer"} of ${e} ${t} ${n}`;function aA({plan:i,particles:e},t){let{goal:n,considered:s}=i,r=d=>d.length/2-(n?.kind==="collected"?Do(d,n):0),o=e.first.length/2,a=r(lt(t.particles))-r(e.last),l=n?.kind==="collected"?"stay outside the goal area":"stay on the surface",c=i.lost??s?.find(({chosen:d})=>d)?.lost??null,h=t.lost-(c??NaN),u=c===null?`${_e(t.lost,1)} in all is lost`:Math.abs(h)<Wi?"nothing more is lost":`${_e(Math.abs(h),1)} ${h>0?"more":"less"} is lost`;return o<Np?`${dy(a,o,"particles",l)}, and ${u}`:u}function lA({plan:{treatment:i},treated:e},t){let n=vn(i,t.treated);if(!i||!e||!n)return null;let s=_s(i),r=(o,a)=>o.filter(l=>s[ws(s,i,l)].degree===a).length;return["little","much"].map(o=>dy(r(n,o)-r(e.last,o),n.length,"places",`get ${tr[o]}`)).join(", ")}function fy(i,{stroke:e,way:t,time:n}){let s=kp(i,e),r=`The stroke takes ${Be(n,1)} s with the way to it, and ${Be(t,2)} m in contact.`,o=i.plan.headings?.[e];if(!s)return[r,...o?[o]:[]];let a=ku(i),l=Math.abs(a-s.performance)<Wi?`${_e(a,1)} as with it`:`${_e(s.performance,1)} instead of ${_e(a,1)}`,c=i.plan.treatment?lA(i,s):aA(i,s);return[`Predicted without stroke ${e+1}: ${l}${c?`; ${c}`:""}.`,r,...o?[o]:[]]}function cA(i,e,t,n){let{width:s,height:r}=i.viewBox.baseVal,o=Math.max(s,r)/100,a=e.plan.strokes.map(u=>lt(u)),l=a.filter((u,d)=>d!==t).map(Du).join(""),c=n?a[t]:null,h=[ie("path",{d:l,class:"w-line","stroke-width":.6*o})];if(c&&c.length>=4){let[u,d,f,p]=c.slice(-4),x=Math.atan2(d-p,f-u)*180/Math.PI,g=ie("path",{d:`M${3*o} 0L${-2*o} ${2.6*o}V${-2.6*o}z`,class:"w-line-tip",transform:`translate(${1e3*f} ${-1e3*p}) rotate(${x})`});h.push(...["w-line w-casing","w-line w-line-chosen"].map((m,y)=>ie("path",{d:Du(c),class:m,"stroke-width":(y?1.6:3)*o})),g)}i.insertBefore(ie("g",{},...h),i.querySelector(".w-dots"))}function py(i,e){let t=kp(i,e);if(!t)return[];let{treatment:n}=i.plan,s=(o,a)=>{let l=a?i.treated?.last??null:vn(n,t.treated),c=a?i.particles.last:lt(t.particles),h=`${o}, at the end: ${uo(i)} with ${c.length/2} particles`,u=n?ul(o,i,l):nr(Hi(i,[{mark:"believed",places:c}],h),o),d=u?.querySelector("svg.w-picture");return d&&cA(d,i,e,a),u},r=[s(`Predicted with stroke ${e+1}`,!0),s("Predicted without it",!1)].filter(o=>o!==null);return[M("div",{class:"w-pair"},...r),...n?[dl(n)]:[]]}var my=3,gy=i=>`${i>0?"+":""}${Be(100*i,1)}`,Op=i=>i.length>1?`${i.slice(0,-1).join(", ")} and ${i.at(-1)}`:String(i[0]);function hA(i,e){let t=i.filter(r=>r.marginal!==null);if(t.length<2)return[];let n=t.reduce((r,o)=>o.marginal>r.marginal?o:r),s=t.filter(({marginal:r})=>r<Wi).map(({stroke:r})=>r+1);return[...n.marginal>=Wi?[`Stroke ${n.stroke+1} is predicted to matter most: without it, the plan reaches ${_e(e-n.marginal,1)} instead of ${_e(e,1)}.`]:[],...s.length?[`Without stroke ${Op(s).replace(" and "," or ")} alone, the plan is predicted to reach ${s.some(r=>t.find(o=>o.stroke+1===r).marginal<=-Wi)?"as much or more":"as much"}. It may still help if dirt or tool differ from the belief.`]:[]]}var uA=.05;function dA(i,e){let t=i.growthAt(0),n=e?.interpreted?.estimate;return!e||!n||t===null||Math.abs(t-n.mean)<uA?[]:[`The prediction begins at ${_e(t,1)}, ${t<n.mean?"below":"above"} the estimate of ${Gt(n)} after round ${e.number}. It starts from one random draw from the new belief; the estimate is the mean of all draws.${e.events.some(Ka)?` A push, a collision or hand guiding in round ${e.number} may have left open what was wiped there.`:""}`]}function fA({plan:{goal:i}},e,t){let n=e.filter(({gain:r},o)=>{let a=0;return r<=-Wi&&e.slice(o).some(l=>(a+=l.gain)>-Wi)});if(i?.kind!=="collected"||!n.length)return[];let s=Math.max(...n.map(({gain:r})=>-r));return[`${n.length>1?"Strokes":"Stroke"} ${Op(n.map(({stroke:r})=>r+1))} ${n.length>1?"are":"is"} predicted to take dirt out of the goal area, ${Be(100*s,1)} points at most. The tool pushes all dirt in its way; later strokes bring it back, and the plan reaches ${_e(t,1)}.`]}function pA(i){let e=new Map;i.forEach((s,r)=>e.set(s,[...e.get(s)??[],r+1]));let n=[...e].sort(([,s],[,r])=>r.length-s.length).slice(0,my).map(([s,r])=>`${e.size===1&&i.length>1?"All strokes":r.length>1?`Strokes ${Op(r)}`:`Stroke ${r[0]}`}: ${s}`);return e.size>my?[...n,"Choose another stroke in the table to see how the tool is turned in it."]:n}var xy=(i,e)=>M("div",{class:"w-choice",tabindex:0,role:"group","aria-label":i},e),Ou=class{constructor(e,t){this.seek=e;this.choose=t}seek;choose;element=M("div");round=null;stroke=null;rejected=null;kept=null;show(e,t,n){if(e&&e===this.round)return;(this.stroke!==null||this.rejected)&&this.choose(null),[this.round,this.stroke,this.rejected,this.kept]=[e,null,null,null];let s=e?uy(e):[],{without:r,predicted:o,another:a=r?.length?null:void 0,...l}=e?.plan??{},[c,h,u]=[l.why??[],l.considered??[],l.headings??[]],d=e?ku(e):NaN,f=or(e?[...dA(e,t),...hA(s,d),...fA(e,s,d)]:[]);e&&a&&f.append(M("li",{},...this.describeAnother(e,a))),f.append(...or([...a===null&&(o??0)<1-Wi?["A repetition of a stroke at the end is predicted to gain nothing."]:[],...pA(u),...c]).children),this.element.replaceChildren(f.childElementCount?f:M("p",{class:"w-quiet"},n),...h.length?[this.makeCandidates(h)]:[],...e&&s.length?[this.makeStrokes(e,s)]:[])}publish(){this.round&&this.choose({round:this.round,stroke:this.stroke,rejected:this.rejected})}preview(e){let t=s=>()=>{this.rejected!==s&&(this.rejected=s,this.publish())},n=()=>t(this.kept)();return e?{pointerenter:t(e),pointerleave:n,focusin:t(e),focusout:n}:{}}makeKeeper(e,t){return M("button",{type:"button",class:"w-link","aria-pressed":"false",title:"Show its strokes in the scene",click:({currentTarget:n})=>{this.kept=this.kept===t?null:t;for(let s of this.element.querySelectorAll(".w-link[aria-pressed]"))s.setAttribute("aria-pressed",String(s===n&&this.kept!==null));this.rejected=this.kept,this.publish()}},e)}describeAnother({plan:{strokes:e}},{gain:t,line:n,way:s}){let r=e.findIndex(l=>String(l)===String(n)),o={name:r<0?"One more stroke":`Repetition of stroke ${r+1}`,lines:[n]},a=r<0?"One more stroke":`Stroke ${r+1} once more at the end`;return[M("span",this.preview(o),this.makeKeeper(a,o)),` is predicted to gain ${Be(100*t,1)} points with ${Be(s,2)} m in contact.`]}makeCandidates(e){let t=["Strategy","Score","Share","Lost","Contact","Time"],n=[...e].sort((s,r)=>(r.score??-1/0)-(s.score??-1/0)).map(s=>{let{strategy:r,chosen:o,score:a,predicted:l,lost:c,strokes:h,in_contact:u,duration:d,error:f,lines:p}=s,x=!o&&p?.length?{name:`Rejected plan: ${r}, ${p.length} strokes`,lines:p}:null,g=[rn(a,m=>Be(m,2)),rn(l,_e),rn(c,_e),rn(u,m=>`${Be(m,2)} m`),rn(d,m=>`${Be(m,0)} s`)];return M("tr",{"data-chosen":o,title:typeof h=="number"&&`${h} strokes`,...this.preview(x)},M("th",{scope:"row"},o&&"\u2713 ",x?this.makeKeeper(r,x):r,o&&M("span",{class:"w-hidden"}," (chosen)")),...f?[M("td",{class:"w-none-found",colspan:t.length-1},`no plan: ${f}`)]:g.map(m=>M("td",{},m)))});return xy("Candidate plans",Mi(t,n,"Share: predicted performance. Lost: predicted share of lost dirt. Score: predicted share of the dirt that reaches the goal, minus three times the lost share, minus what heaps near an edge put at risk, minus costs of remaining dirt by its distance, of path length and time."))}makeStrokes(e,t){let n=t.some(({marginal:l})=>l!==null),s=["Stroke","In turn",...n?["Marginal"]:[],"Contact","Time"],r=M("td",{colspan:s.length,class:"w-stroke"}),o=M("tr",{},r),a=t.map(l=>{let{stroke:c,gain:h,marginal:u,way:d,start:f,time:p}=l,x=M("button",{type:"button",class:"w-link","aria-expanded":"false","aria-label":`Stroke ${c+1}`,click:()=>{let m=this.stroke===c;this.stroke=m?null:c;for(let y of a)y.querySelector("button").setAttribute("aria-expanded",String(y===g&&!m));o.remove(),m||(r.replaceChildren(...py(e,c),or(fy(e,l))),g.after(o),o.scrollIntoView({block:"nearest"}),this.seek(e.start+f)),this.publish()}},String(c+1)),g=Rl(x,[gy(h),...n?[rn(u,gy)]:[],`${Be(d,2)} m`,`${Be(p,1)} s`]);return g});return xy("Strokes",Mi(s,a,`Predicted gain of each stroke in performance, in points. In turn: rise while it is wiped; a stroke without a rise may prepare a later one.${n?" Marginal: the whole plan minus the plan without it.":""} Contact: its way in contact. Time: with the way to it.`))}};var fl=(i,e,...t)=>M("details",{class:"w-section",open:e},M("summary",{},M("h2",{},i)),...t),yy=["performance unknown","undecided by touch","cannot be told","unknowable by touch"],Fp=(i,e)=>i?"met":yy.includes(e??"")?"unknown":"unmet";function po({rounds:i,ended:e,live:t}){let n=r=>i.length>0&&i.every(({plan:o})=>o.kind===r);return t?{state:"live",text:"running"}:n("planned")?{state:"planned",text:"planned only"}:n("logged")?{state:"logged",text:"from the log"}:e?{state:Fp(e.met,yy.includes(e.badge??"")?e.badge:e.verdict),text:e.badge??e.verdict??(e.met?"goal met":"stopped")}:{state:"broken",text:"ended early"}}function mo({rounds:i,ended:e},{number:t,plan:{kind:n},interpreted:s,over:r}){return n==="planned"?"planned only":n==="logged"?"from the log":s?(i.findLast(a=>a.interpreted)?.number===t?e?.badge:null)??s.verdict:r?"no result":"running"}function Bp(i,{round:e,time:t,phase:n}){if(t>=e.length-1e-6&&e.interpreted)return mo(i,e);let s=e.plan.phases[n],r=typeof s?.stroke=="number"?` \xB7 stroke ${s.stroke+1} of ${e.plan.strokes.length}`:"";return`${s?Rs(s.name):"starting"}${r}`}var fo=(i,e)=>[M("dt",{},i),M("dd",{},e)],vy="beside the surface";function pl({height:i,tool:e,contact:t,round:{plan:n}}){return i===null?wn:e&&t!=="contact"&&!Cx(n.surface,e)?vy:`${Be(1e3*i,1)} mm`}var Uu="The episode was kept without a recording: the page shows its telemetry and its events.",Up=300,Fu=class{constructor(e,t,n){this.recording=e;this.clock=t;this.why=new Ou(l=>t.seek(l),n);let{contact:s,force:r,height:o,performance:a}=this.live;this.element=M("aside",{class:"w-words","aria-label":"Details of the run",tabindex:0},M("div",{class:"w-now"},this.headline,this.below,M("dl",{class:"w-values"},M("div",{},M("dt",{},"Contact"),s),M("div",{},M("dt",{},"Force"),r),M("div",{},M("dt",{title:"Height of the tool over the surface as believed"},"Tool height"),o),M("div",{},this.performanceName,a))),this.complaint,fl("Why this plan",!0,this.why.element),fl("Result",!0,this.after),fl("Events",!0,this.events),fl("Numbers",!0,this.numbers),fl("Log",!1,this.logCount,this.log))}recording;clock;element;headline=M("p",{class:"w-headline"});below=M("p",{class:"w-quiet"});live={contact:M("dd"),force:M("dd"),height:M("dd"),performance:M("dd")};performanceName=M("dt",{},"Predicted");why;after=M("div");events=M("div");numbers=M("div");log=M("ol",{class:"w-log"});logCount=M("span",{class:"w-quiet"});complaint=M("p",{class:"w-complaint",hidden:!0});shownEvents=[];show(){let{recording:e,clock:t}=this,n=e.at(t.time);this.showNow(n);let s=n?.round;jn(this.after,[s?.number,s?.start,e.rounds.length,!!s?.interpreted,!!s?.truth,e.live,e.ended?.badge])&&this.showRound(s??null);let{stages:r,happenings:o,head:a,ended:l,broken:c,unknown:h}=e;jn(this.events,[r.length,o.length,!!a,!!l,c,h])&&this.showRun();for(let{element:u,start:d,end:f}of this.shownEvents)u.toggleAttribute("data-now",t.time>=d-.05&&t.time<=f+.05)}showNow(e){let{recording:t,clock:n}=this,s=t.live&&(n.following||!e)?t.stages.at(-1):void 0;if(!e){ze(this.headline,s?.words??(t.live?t.head?"No round has begun.":"The recording is empty so far.":"The recording has no rounds.")),ze(this.below,"");for(let f of Object.values(this.live))ze(f,wn);delete this.live.height.dataset.words;return}let{round:r,time:o,normal:a,performance:l,contact:c}=e,h=t.rounds.length;ze(this.headline,Yi(s&&s.stage!=="executing"?s.words:Bp(t,e))),ze(this.below,`Round ${r.number} of ${h}${r.plan.kind==="planned"?" (planned only)":""} \xB7 ${Je(o)} of ${Je(r.length)}`),ze(this.live.contact,c==="contact"?"yes":c==="pushed"?"pushed":"none"),ze(this.live.force,rn(a,f=>`${Be(f,1)} N`));let u=pl(e);ze(this.live.height,u),this.live.height.toggleAttribute("data-words",u===vy);let d=t.resultAt(n.time)?.interpreted;ze(this.performanceName,d?"Estimated":"Predicted"),ze(this.live.performance,d?_e(d.estimate.mean):rn(l,_e))}showRound(e){let{rounds:t}=this.recording;if(this.why.show(e,t[t.indexOf(e)-1]??null,e?e.plan.kind==="logged"?Uu:"The recording states no reasons for this plan.":"No plan yet."),!e?.interpreted){let r=e?e.plan.kind==="planned"?"This plan was not executed.":e.plan.kind==="logged"?Uu:this.recording.live?"The round is not finished.":"The round has no result because the run ended early.":"No round yet.";this.after.replaceChildren(M("p",{class:"w-quiet"},r));return}let{interpreted:n,truth:s}=e;this.after.replaceChildren(M("p",{class:"w-quiet"},`Round ${e.number}, known from ${Je(e.end)} on.`),M("p",{},M("strong",{},mo(this.recording,e)),n.ending?` \xB7 ${n.ending}`:""),M("dl",{class:"w-facts"},...fo("Predicted",rn(e.plan.predicted,_e)),...fo("Estimated",Gt(n.estimate)),...fo("From touch only",Gt(n.by_touch)),...typeof s?.performance=="number"?fo("True",_e(s.performance)):[],...n.found?fo("Surface","not at its believed pose"):[]),or(n.words))}showRun(){let{recording:e,clock:t}=this,n=e.happenings.slice(0,Up);this.shownEvents=[],this.events.replaceChildren(n.length?M("ul",{class:"w-events"},...n.map(({start:o,end:a,round:l,kind:c,words:h,source:u})=>{let d=M("button",{type:"button","data-source":u,click:()=>t.seek(o)},M("span",{class:"w-when"},Je(o)),M("span",{},M("strong",{},c),` in round ${l}: ${h}`));return this.shownEvents.push({element:d,start:o,end:a}),M("li",{},d)}),e.happenings.length>Up&&M("li",{class:"w-quiet"},`and ${e.happenings.length-Up} more`)):M("p",{class:"w-quiet"},"None.")),this.showNumbers(),this.log.replaceChildren(...e.stages.slice(-500).map(({round:o,stage:a,words:l})=>M("li",{},M("span",{class:"w-when"},`${o} ${a}`),` ${l}`))),ze(this.logCount,e.stages.length>500?`The list shows the last 500 of ${e.stages.length} entries.`:"");let{broken:s,unknown:r}=e;this.complaint.hidden=!s&&!r,ze(this.complaint,[s?`${s} ${s===1?"line":"lines"} of this recording could not be read.`:"",r?`${r} ${r===1?"piece":"pieces"} of unknown kind ${r===1?"was":"were"} skipped.`:""].join(" ").trim())}showNumbers(){let{head:e,ended:t,rounds:n}=this.recording;if(!e)return;let{task:s,robot:r}=e,o=[...s?[["Task",`${s.action} ${s.medium} with ${s.tool} on ${s.surface}`],["Strategy",s.strategy],["Target",_e(s.target)],["Seed",String(s.seed)]]:[],...r?[["Robot",`${r.name}, ${r.variables.length} variables`]]:[],["Program",e.program],...e.begun?[["Started",e.begun]]:[],...t?.episode?[["Episode",t.episode]]:[]],a=new Set(o.map(([c])=>c)),l=new Map([[null,o]]);for(let c of t?.facts??[]){if(a.has(c[0]))continue;let h=n.length>1?mA(c,n[0].number):null;l.set(h,[...l.get(h)??[],[c[0],c[1]]])}this.numbers.replaceChildren(...[...l].flatMap(([c,h])=>[...l.size>1?[M("h3",{},c===null?`Whole run, ${n.length} rounds`:`Round ${c}`)]:[],M("dl",{class:"w-facts"},...h.flatMap(([u,d])=>fo(String(u),String(d))))]))}},mA=([i,e,t],n)=>t!==void 0?t:/ in \d+ rounds$/.test(e)||/^(Target performance|Tool held|Maximum path error|Minimum clearance|Distance in contact|Distance in total|Goal|Steps|Links|Joints held at their ready positions)$/.test(i)?null:n;function by(i,e,t){qn(i,11,{align:"center"});let{step:n,times:s}=uu(e.from,e.to,Math.max(2,e.span/76)),r=n<.1?2:n<1?1:0;for(let o of s){let a=e.x(o);en(i,a,t.top+t.height,a,e.height,"grid"),i.fillStyle=Me("quiet"),i.fillText(Je(o,r),Math.min(Math.max(a,e.left+10),e.width-16),t.top+t.height/2)}}function ml(i,e,t,n=1){if(t<i.from||e>i.to)return null;let s=Math.max(i.x(e),i.left);return[s,Math.max(Math.min(i.x(t),i.width-i.right),s+n)]}function _y(i,e,t,n){qn(i,11,{weight:600});for(let s of n.rounds){let r=ml(e,s.start,s.end);if(!r)continue;let[o,a]=r;i.fillStyle=Me("round"),i.beginPath(),i.roundRect(o+.5,t.top,Math.max(1,a-o-1),t.height,4),i.fill(),i.fillStyle=Me("ink"),ys(i,`${s.number} \xB7 ${mo(n,s)}`,o+7,t.top+t.height/2+.5,a-o-12),s.start>e.from&&en(i,e.x(s.start),t.top,e.x(s.start),e.height,"rule")}}function wy(i,e,t,n){qn(i,10.5);for(let{start:s,plan:r,length:o}of n.rounds)for(let a of r.phases){let l=ml(e,s+a.start,s+Math.min(a.end,Math.max(o,a.start)));if(!l)continue;let[c,h]=l;i.fillStyle=Me(a.contact?"wiping":"lane"),i.fillRect(c,t.top,Math.max(1,h-c-1),t.height),i.fillStyle=Me(a.contact?"ink":"quiet");let u=a.stroke===null?"":String(a.stroke+1),d=u?`${u} ${a.name}`:Rs(a.name),f=t.top+t.height/2+.5;u&&i.measureText(d).width>h-c-7?i.measureText(u).width<=h-c-3&&i.fillText(u,(c+h-i.measureText(u).width)/2,f):ys(i,d,c+4,f,h-c-7)}}function My(i,e,t,n){pp(i,e,t);for(let s of n.rounds){if(!ml(e,s.start,s.end))continue;let{contact:r,pushed:o}=s.contacts;for(let[a,l]of[["contact",r],["pushed",o]]){i.fillStyle=Me(a);for(let[c,h]of l){let u=ml(e,s.start+c,s.start+h);u&&(a==="contact"?i.fillRect(u[0],t.top,u[1]-u[0],t.height):gA(i,t,u))}}}}function gA(i,e,[t,n]){i.fillRect(t,e.top,n-t,e.height),sl(i,[t,e.top,n-t,e.height],()=>{for(let s=t-e.height;s<n;s+=5)en(i,s,e.top+e.height,s+e.height,e.top,"paper",1.4)})}function Sy(i,e,t){if(!e.count)return;let n=Math.max(Math.floor(i.left),Math.floor(i.x(e.start))),s=Math.min(i.width-i.right,i.x(e.start+e.t.at(-1))),r=e.place(i.t(n)-e.start)[0];for(let o=n;o<=s;o++){let a=e.place(i.t(o+1)-e.start)[0];t(o,r,Math.max(a,r+1)),r=a}}var go={collision:"M-6 5.5H6L0 -6z",hand:"M-5 0a5 5 0 1 0 10 0a5 5 0 1 0 -10 0",event:"M-4 -4h8v8h-8z"},zp=({source:i,kind:e})=>i==="push"?"actual":e===Ys?"collision":e==="hand guiding"?"hand":"event";function Ty(i,e,t,n){pp(i,e,t);let s=t.top+t.height/2;for(let r of n.happenings){let o=ml(e,r.start,r.end,3);if(!o)continue;let[a,l]=o,c=zp(r);if(i.fillStyle=i.strokeStyle=Me(c),c==="actual"){i.lineWidth=1.5,i.setLineDash(il),i.strokeRect(a+.5,t.top+1.5,Math.max(2,l-a-1),t.height-3),i.setLineDash([]);continue}i.fillRect(a,s-2.5,l-a,5),xA(i,go[c],a,s)}}function xA(i,e,t,n){let s=new Path2D(e);i.save(),i.translate(t,n),i.fill(s),i.strokeStyle=Me("paper"),i.lineWidth=1,i.stroke(s),i.restore()}var yA=13,vA=.006,Ey={least:.04,most:.16},Ay=.02,bA=1,Vp=["collision","hand","actual"];function _A({t:i,force:e,count:t},n,s){let[r,o]=[-1,bA];for(let a=Math.max(0,li(i,n));a<t&&i[a]<=s;a++){let l=Math.hypot(e[3*a],e[3*a+1],e[3*a+2]);l>o&&([r,o]=[a,l])}return r}function wA({tool:i,force:e},t,n){let s=new E().fromArray(e,3*t),r=Math.min(Ey.most,Math.max(Ey.least,vA*s.length())),o=new E().fromArray(i,7*t),a=s.normalize(),l=o.clone().addScaledVector(a,r),c=new E(Math.abs(a.x)<.7?1:0,Math.abs(a.x)<.7?0:1,0).cross(a).normalize(),u=[c,c.clone().negate(),a.clone().cross(c),c.clone().cross(a)].flatMap(f=>[...l.toArray(),...l.clone().addScaledVector(a,-Ay).addScaledVector(f,.5*Ay).toArray()]),d=[...o.toArray(),...l.toArray()];return[...n?cu(d,yp):d,...u]}var Bu=class{group=new ot;points=ps([],tu(),yA,{nearer:.985,vertexColors:!0});arrows=new oo(4,[]);key="";starts=[];pushes=[];constructor(){this.group.add(this.points,this.arrows.line)}show(e,t,n,s,r){let o=`${t.start} ${t.number} ${e.happenings.length} ${t.count>0} ${r}`;o!==this.key&&(this.key=o,this.arrows.paint(Vp.map(l=>new Re(Me(l)))),this.build(e,t));let a=this.starts.filter(l=>l<=n).length;this.points.visible=s&&a>0,this.points.geometry.setDrawRange(0,a),this.arrows.show(s?this.pushes.filter(l=>l<=n).length:0)}build(e,t){let n=[],s=[];this.starts=[],this.pushes=[],this.arrows.clear();for(let r of e.happenings){let[o,a]=[r.start-t.start,r.end-t.start];if(o<0||o>t.length||r.source==="push"&&e.happenings.some(f=>f.source==="event"&&f.start<r.end&&f.end>r.start))continue;let c=t.toolAt((o+a)/2);if(!c)continue;let h=zp(r);this.starts.push(o),n.push(c[0],c[1],c[2]),s.push(...new Re(Me(h)).toArray());let u=Vp.includes(h)?_A(t,o,a):-1;if(u<0)continue;let d=wA(t,u,r.source==="push");for(let f=0;f<d.length;f+=6)this.arrows.push(d.slice(f,f+6),Vp.indexOf(h)),this.pushes.push(o)}this.points.geometry.dispose(),this.points.geometry=new We,this.points.geometry.setAttribute("position",new Ne(n,3)),this.points.geometry.setAttribute("color",new Ne(s,3))}};var MA=null;function ir(){return MA??=SA()}function SA(){let i=document.createElement("canvas").getContext("webgl2");if(!i)return!0;let e=i.getExtension("WEBGL_debug_renderer_info"),t=/swiftshader|llvmpipe|softpipe|software|basic render/i.test(e?String(i.getParameter(e.UNMASKED_RENDERER_WEBGL)):"");return i.getExtension("WEBGL_lose_context")?.loseContext(),t}var TA=26e5,Ry=[.75,.6,.5],EA=1.5,AA=700,RA=70,CA=6,zu=class{software=ir();renderer;width=0;height=0;ratio=0;coarse=0;moved={last:0,took:0,frames:0};rest;constructor(e){this.renderer=new Vh({canvas:e,stencil:!0,antialias:!this.software,alpha:!this.software,powerPreference:"high-performance"}),this.renderer.debug.checkShaderErrors=!1,this.renderer.shadowMap.enabled=!0,this.renderer.shadowMap.type=Gs,this.renderer.shadowMap.autoUpdate=!this.software}hasShadows(e){return!this.software||e}get shadowSize(){return this.software?512:1024}size(e,t){[this.width,this.height,this.ratio]=[e,t,0]}paint(){this.software&&this.renderer.setClearColor(new Re(Me("scene")))}draw(e,t,n,s){clearTimeout(this.rest),this.software&&!n&&this.keepUp(performance.now()),this.sharpen(n),this.renderer.shadowMap.needsUpdate=n,this.renderer.render(e,t),n||(this.rest=setTimeout(s,AA))}destroy(){clearTimeout(this.rest),this.renderer.dispose(),this.renderer.forceContextLoss()}keepUp(e){let{moved:t}=this,n=e-t.last;t.last=e,!(n>500)&&(t.took+=n,!(++t.frames<CA)&&(t.took/t.frames>RA&&this.coarse+1<Ry.length&&this.coarse++,t.took=t.frames=0))}sharpen(e){let t=Math.sqrt(TA/(this.width*this.height)),n=Math.min(devicePixelRatio||1,2,Math.max(1,t)),s=this.software?e?Math.min(Math.max(EA,n),t):Ry[this.coarse]:n;s!==this.ratio&&(this.ratio=s,this.renderer.setPixelRatio(s),this.renderer.setSize(this.width,this.height,!1))}};var xo=8,Cy=i=>Math.min(xo-1,Math.max(0,Math.floor(i*xo))),Py=()=>M("div",{class:"w-scale w-reach"},M("b",{},"Base poses"),ar(Array.from({length:xo},(i,e)=>({colour:`band-${e+1}`,label:`\u2265 ${_e(e/xo,e%2)}`})),"Scale in percent"),M("p",{},"share of the path that is in reach; grey: chosen without being rated; the tip points where the base faces; ringed: chosen, in order"));var Hu=class{group=new ot;lines=["paper","rejected"].map((e,t)=>Fn([],Et(new Xt({linewidth:4-2*t,polygonOffset:!0,polygonOffsetFactor:-7-t,polygonOffsetUnits:-7-t}),e)));shown=null;constructor(){this.group.add(...this.lines)}show(e,{pose:t,shape:n}){if(this.group.visible=e!==null,!e||e===this.shown)return;this.shown=e,$t(this.group,t);let s=e.flatMap(r=>xs(gs(n,ao(r,2.5*En),!1),!1));for(let r of this.lines)nl(r,s)}},Vu=.03,Iy=.006,Gu=[.003,.004,.005],PA=.045;function Ly(i){let e=new Li().absarc(0,0,i,Math.PI/4,7*Math.PI/4,!1);return new zs(e.lineTo(1.9*i,0),10)}var IA=i=>js(e=>{e.arc(32,32,30,0,2*Math.PI),e.fillStyle=Me("ink"),e.fill(),e.font="bold 38px system-ui, sans-serif",e.textAlign="center",e.textBaseline="middle",e.fillStyle=Me("paper"),e.fillText(String(i),32,35)}),Wu=class{group=new ot;shown=null;theme="";get places(){return this.group.visible?this.shown?.poses.map(([e,t])=>new E(e,t,0))??[]:[]}show(e,t){if(this.group.visible=e!==void 0,!e||this.shown===e&&this.theme===t)return;[this.shown,this.theme]=[e,t],el(this.group);let{poses:n,chosen:s}=e,r=Array.from({length:xo},(u,d)=>new Re(Me(`band-${d+1}`))),o=new Re(Me("quiet")),a=this.addMarks(Ly(Vu+Iy),n.length),l=this.addMarks(Ly(Vu),n.length),c=s.map(u=>n[u]).filter(u=>u!==void 0),h=this.addMarks(new Bs(2*Vu,2*Vu+2*Iy,32),c.length);h.material.depthTest=!1,h.renderOrder=8,n.forEach((u,d)=>{a.setMatrixAt(d,Gp(u,Gu[0])),a.setColorAt(d,o),l.setMatrixAt(d,Gp(u,Gu[1])),l.setColorAt(d,u[3]===null?o:r[Cy(u[3])])}),c.forEach((u,d)=>{h.setMatrixAt(d,Gp(u,Gu[2])),h.setColorAt(d,new Re(Me("ink")));let f=new ra(new Br({map:IA(d+1),sizeAttenuation:!1,depthTest:!1}));f.position.set(u[0],u[1],Gu[2]),f.center.set(.5,-.6),f.scale.setScalar(PA),f.renderOrder=9,this.group.add(f)})}addMarks(e,t){let n=new aa(e,Fi(new cn({toneMapped:!1,transparent:!0}),.998),t);return n.frustumCulled=!1,this.group.add(n),n}},LA=new E(0,0,1),Gp=([i,e,t],n)=>new Le().compose(new E(i,e,n),new Rt().setFromAxisAngle(LA,t),new E(1,1,1));var gl=new E;function Yn(i,e,t,n,s,r){let o=2*Math.PI*s/4,a=Math.max(r-2*s,0),l=Math.PI/4;gl.copy(e),gl[n]=0,gl.normalize();let c=.5*o/(o+a),h=1-gl.angleTo(i)/l;return Math.sign(gl[t])===1?h*c:a/(o+a)+c+c*(1-h)}var $u=class i extends Nn{constructor(e=1,t=1,n=1,s=2,r=.1){let o=s*2+1;if(r=Math.min(e/2,t/2,n/2,r),super(1,1,1,o,o,o),this.type="RoundedBoxGeometry",this.parameters={width:e,height:t,depth:n,segments:s,radius:r},o===1)return;let a=this.toNonIndexed();this.index=null,this.attributes.position=a.attributes.position,this.attributes.normal=a.attributes.normal,this.attributes.uv=a.attributes.uv;let l=new E,c=new E,h=new E(e,t,n).divideScalar(2).subScalar(r),u=this.attributes.position.array,d=this.attributes.normal.array,f=this.attributes.uv.array,p=u.length/6,x=new E,g=.5/o;for(let m=0,y=0;m<u.length;m+=3,y+=2)switch(l.fromArray(u,m),c.copy(l),c.x-=Math.sign(c.x)*g,c.y-=Math.sign(c.y)*g,c.z-=Math.sign(c.z)*g,c.normalize(),u[m+0]=h.x*Math.sign(l.x)+c.x*r,u[m+1]=h.y*Math.sign(l.y)+c.y*r,u[m+2]=h.z*Math.sign(l.z)+c.z*r,d[m+0]=c.x,d[m+1]=c.y,d[m+2]=c.z,Math.floor(m/p)){case 0:x.set(1,0,0),f[y+0]=Yn(x,c,"z","y",r,n),f[y+1]=1-Yn(x,c,"y","z",r,t);break;case 1:x.set(-1,0,0),f[y+0]=1-Yn(x,c,"z","y",r,n),f[y+1]=1-Yn(x,c,"y","z",r,t);break;case 2:x.set(0,1,0),f[y+0]=1-Yn(x,c,"x","z",r,e),f[y+1]=Yn(x,c,"z","x",r,n);break;case 3:x.set(0,-1,0),f[y+0]=1-Yn(x,c,"x","z",r,e),f[y+1]=1-Yn(x,c,"z","x",r,n);break;case 4:x.set(0,0,1),f[y+0]=1-Yn(x,c,"x","y",r,e),f[y+1]=1-Yn(x,c,"y","x",r,t);break;case 5:x.set(0,0,-1),f[y+0]=Yn(x,c,"x","y",r,e),f[y+1]=1-Yn(x,c,"y","x",r,t);break}}static fromJSON(e){return new i(e.width,e.height,e.depth,e.segments,e.radius)}};var Wp=new E(0,0,1),$i=(i,e=new E)=>new Le().makeRotationFromQuaternion(new Rt().setFromUnitVectors(Wp,i.clone().normalize())).setPosition(e);function tn(i,e=24){let t=new _a(i.map(([n,s])=>new te(n,s)),e).rotateX(Math.PI/2);return t.setIndex([...t.index.array].filter((n,s)=>{let r=Math.floor(s/6)%(i.length-1),[o,a]=[i[r],i[r+1]];return(o[0]!==a[0]||o[1]!==a[1])&&(s%6<3?o:a)[0]>0}))}function Xu({from:i,to:e,radius:t},n,s,r){let o=e.x-i.x,a=e.y-i.y,l=e.z-i.z,c=o*o+a*a+l*l,h=c>0?Math.min(1,Math.max(0,((n-i.x)*o+(s-i.y)*a+(r-i.z)*l)/c)):0;return Math.hypot(n-i.x-h*o,s-i.y-h*a,r-i.z-h*l)-t}var Dy=.012,Hp=.01,xl=1e-4;function DA({rods:i,box:e,edge:t},n,s,r){let o=0;for(let u of i)o+=Math.exp(-Xu(u,n,s,r)/Dy);let a=Math.abs(n)-e.x+t,l=Math.abs(s)-e.y+t,c=Math.abs(r)-e.z+t,h=Math.hypot(Math.max(0,a),Math.max(0,l),Math.max(0,c))+Math.min(0,Math.max(a,l,c))-t;return Hp*Math.log(o**(-Dy/Hp)+Math.exp(h/Hp))}function NA(i,e){if(i(0)>=0)return 0;let[t,n]=[0,e];for(;n-t>.5*xl;){let s=(t+n)/2;i(s)<0?t=s:n=s}return(t+n)/2}function $p(i,e,[t,n],[s,r],o){let a=Math.ceil((n-t)/o),[l,c]=[Math.asin(s),Math.asin(r)],h=Math.max(2,Math.ceil((c-l)/o)),u=Array.from({length:h+1},(S,b)=>Math.sin(l+b/h*(c-l))),d=[...s<=-1?[-1]:[],...u,...r>=1?[1]:[]],[f,p,x]=[[],[],[]],[g,m]=[new E,new E],y=(S,b,A)=>DA(i,S,b,A)+e;return d.forEach((S,b)=>{let A=b===0&&s<=-1||b===d.length-1&&r>=1,R=S*(i.box.z-e-xl);for(let v=0;v<=a;v++){let T=t+(n-t)*v/a,D=Math.cos(T),P=Math.sin(T),k=A?0:NA(G=>y(G*D,G*P,R),2*i.box.length()),O=k*D,z=k*P,I=y(O,z,R);g.set(O,z,R).applyMatrix4(i.linkFromShell),m.set(y(O+xl,z,R)-I,y(O,z+xl,R)-I,y(O,z,R+xl)-I).transformDirection(i.linkFromShell);let H=b*(a+1)+v;f.push(g.x,g.y,g.z),p.push(m.x,m.y,m.z);let X=H-a-1;b>0&&v<a&&x.push(X,X+1,H,H,X+1,H+1)}}),new We().setAttribute("position",new Ne(f,3)).setAttribute("normal",new Ne(p,3)).setIndex(x)}var kA=.8,OA=[15,85,155,225],UA=[8,40,72,104],FA=[-30,-95,-160],Xp=(...[i,e,t,n])=>new $u(i,e,t,2,n);function ky(i,e,t,n){let s=e.to.clone().sub(e.from),r=s.lengthSq()>0?s.normalize():Wp.clone(),o=t?t.back.clone().sub(e.to).dot(r):1/0,a=o>kA*e.radius,l=t?(a?t.normal:t.side).clone():new E(1,0,0),c=l.addScaledVector(r,-l.dot(r));c.lengthSq()<1e-4&&c.set(r.y,r.z,r.x).cross(r),c.normalize();let h=new Le().makeBasis(c,r.clone().cross(c),r).setPosition(e.to),u=(f,p,x=new Le)=>i(f,p,h.clone().multiply(x)),d=e.to.distanceTo(e.from);a?BA(u,e.radius,d,t!==null,n):zA(u,e.radius,d,o,t.sizes[0]/2),t&&VA(u,a,e.radius,t,h)}var yo=(i,e,t)=>new Le().makeTranslation(i,e,t),Oy=(i,e)=>$i(e.clone().sub(i),i.clone().lerp(e,.5));function BA(i,e,t,n,s){let[r,o]=[-t-1.05*e,-.62*e];i("casing",tn([[0,r],[.36*e,r],[.42*e,r+.1*e],[.42*e,r+.3*e],[.33*e,o-.25*e],[.3*e,o],[0,o]],24)),i("joint",tn([[.3*e,o-.32*e],[.37*e,o-.3*e],[.37*e,o-.14*e],[.3*e,o-.12*e]],24)),i("ring",tn([[.4*e,r+.34*e],[.435*e,r+.34*e],[.43*e,r+.4*e],[.39*e,r+.4*e]],24)),i("casing",Xp(.27*e,1.02*e,1.25*e,.11*e),yo(.29*e,0,-.06*e)),i("joint",Xp(.1*e,.8*e,.8*e,.04*e),yo(.41*e,0,-.1*e));let[a,l]=n?[OA,.25*e]:[UA,.42*e],c=new E(n?0:-.12*e,0,(n?.45:.3)*e);for(let h of[-.385,-.14,.14,.385])Ny(i,a,l,c.clone().setY(h*e),.088*e);Ny(i,FA,l,c.clone().setY((s?-.3:.3)*e),.1*e)}function Ny(i,e,t,n,s){let r=e.map(o=>{let a=o*Math.PI/180;return new E(Math.cos(a),0,Math.sin(a)).multiplyScalar(t).add(n)});r.slice(1).forEach((o,a)=>{let l=r[a],[c,h]=[l.distanceTo(o)/2,s*(1-.06*a)],u=a===r.length-2?c+.6*h:c-.35*h;i("casing",tn([[0,-c],[.85*h,.35*h-c],[h,.6*h-c],[h,u-.5*h],[.8*h,u-.1*h],[0,u]],12),Oy(l,o)),i("joint",new Di(.98*h,10,6),yo(l.x,l.y,l.z))})}function zA(i,e,t,n,s){let r=-t-.9*e;i("casing",tn([[0,r],[.8*e,r],[.84*e,r+.08*e],[.84*e,-.2*e],[.76*e,-.12*e],[0,-.12*e]],28)),i("ring",tn([[.84*e,-.5*e],[.88*e,-.48*e],[.88*e,-.36*e],[.84*e,-.34*e]],28)),i("joint",Xp(1.5*e,.86*e,.42*e,.08*e),yo(0,0,.02*e));let o=.16*e,a=.3*e,l=Math.min(s,.75*e)+o/2,c=Math.sqrt(Math.max(0,(e+.008)**2-(l+o/2)**2-a**2)),h=Math.min(n+.012,c);for(let u of[-l,l])i("casing",new Nn(o,2*a,h-.05*e),yo(u,0,(h+.05*e)/2))}function VA(i,e,t,{back:n,normal:s,side:r,sizes:o},a){let l=a.clone().invert(),c=n.clone().applyMatrix4(l),h=new Le().extractRotation(l),u=new Le().makeBasis(r.clone().transformDirection(h),s.clone().cross(r).transformDirection(h),s.clone().transformDirection(h)),d=.006;if(i("handle",new Nn(.62*o[0],.62*o[1],d),u.setPosition(c)),!e)return;let f=new E(0,0,.45*t);i("handle",new ks(.12*t,.98*t,4,14),yo(f.x,f.y,f.z)),i("handle",tn([[.075*t,-f.distanceTo(c)/2],[.075*t,f.distanceTo(c)/2]],12),Oy(f,c))}var vo=class{worldFromLink;joints;motion=new Le;constructor(e){this.joints=e.map(t=>({...t,parentFromJoint:At(t.pose),direction:new E(...t.axis)})),this.worldFromLink=Array.from({length:e.length+1},()=>new Le)}update(e,t){At(e,this.worldFromLink[0]),this.joints.forEach(({parent:n,parentFromJoint:s,direction:r,kind:o,offset:a,terms:l},c)=>{let h=a;for(let[d,f]of l)h+=f*(t[d]||0);let u=this.worldFromLink[c+1].multiplyMatrices(this.worldFromLink[n],s);o==="revolute"?u.multiply(this.motion.makeRotationAxis(r,h)):o==="prismatic"&&u.multiply(this.motion.makeTranslation(r.x*h,r.y*h,r.z*h))})}};var GA=.56,Uy=.82,zy=.005,Vy=.03,Fy=.9;function Gy({robot:i,tool:e},t){if(!i)return[];let n=WA(i),s=n.find(r=>r.rods.length>0&&By(e,t,i,n,r));return i.links.map(({name:r,arm:o,shapes:a},l)=>{let c={casing:[],joint:[],ring:[],handle:[]},h=(g,m,y)=>{if(!m.hasAttribute("position"))return;m.deleteAttribute("uv");let S=m.index?m:mx(m);c[g].push(y?S.applyMatrix4(y):S)},u=n[l],[d]=u.rods,f=Yu(u,u.before?[u.before,...u.after]:u.after),p=By(e,t,i,n,u),x=a.length===1&&!u.after.length&&(p!==null||HA(u,s));if(d&&!o&&/head/i.test(r))JA(h,d,u.worldFromLink);else if(d&&x)ky(h,d,p,/left/i.test(r));else if(!u.trunk||!KA(h,u))for(let g of u.rods)XA(h,g,f);for(let g of a)g.kind!=="capsule"&&QA(h,g,o?null:u.worldFromLink,t);return u.before&&YA(h,i.joints[l-1],u),Object.fromEntries(Object.entries(c).filter(([,g])=>g.length).map(([g,m])=>[g,px(m)]))})}function HA(i,e){let t=n=>n?`${n.rods.map(({from:s,to:r,radius:o})=>[s.distanceTo(r),o].map(a=>a.toFixed(3)))} ${t(n.before)}`:"";return e!==void 0&&t(i)===t(e)}var yl=i=>i.clone().invert(),Yp=(i,e)=>i.map(({from:t,to:n,radius:s})=>({from:t.clone().applyMatrix4(e),to:n.clone().applyMatrix4(e),radius:s})),Yu=({worldFromLink:i},e)=>e.flatMap(({rods:t,worldFromLink:n})=>Yp(t,yl(i).multiply(n)));function WA(i){let e=new vo(i.joints);e.update([0,0,0,0,0,0,1],[]);let t=[];return i.links.forEach(({arm:n,shapes:s},r)=>{let o=i.joints[r-1],a=o?t[o.parent]:null,l=a&&(a.rods.length?a:a.before),c=e.worldFromLink[r],h=s.flatMap(g=>g.kind==="capsule"?[$A(g)]:[]),u=l?Yu({worldFromLink:c},[l]).flatMap(({from:g,to:m})=>[g,m]):[new E],d=g=>Math.min(...u.map(m=>m.distanceTo(g)));for(let g of h)d(g.to)<d(g.from)-1e-6&&([g.from,g.to]=[g.to,g.from]);let f=new E().setFromMatrixPosition(c),p=a!==null&&l!==a&&f.distanceTo(new E().setFromMatrixPosition(a.worldFromLink))<.001&&!qA(i.joints[a.index-1],a),x={index:r,rods:h,before:l,after:[],worldFromLink:c,trunk:!n&&h.length>0&&(h.length>1||!l),crossed:p};h.length&&l?.after.push(x),t.push(x)}),t}function $A({pose:i,length:e,radius:t}){let n=At(i),[s,r]=[-e/2,e/2].map(o=>new E(0,0,o).applyMatrix4(n));return{from:s,to:r,radius:t}}function By(i,e,{joints:t},n,s){let r=i.link??0;for(;r>s.index&&t[r-1].kind==="fixed";)r=t[r-1].parent;if(i.link===null||r!==s.index)return null;let o=n[i.link],a=yl(s.worldFromLink).multiply(o.worldFromLink).multiply(At(i.solid.pose)),l=Bi(i.solid,e);l.computeBoundingBox();let c=l.boundingBox,h=c.getSize(new E),u=h.x<=h.y?"x":"y",d=f=>new E().setComponent("xyz".indexOf(f),1).transformDirection(a);return{back:c.getCenter(new E).setZ(c.max.z).applyMatrix4(a),normal:d("z"),side:d(u),sizes:u==="x"?[h.x,h.y]:[h.y,h.x]}}function XA(i,{from:e,to:t,radius:n},s){let r=t.clone().sub(e),o=r.length()/2,a=$i(o>0?r:new E(0,0,1),e.clone().lerp(t,.5)),l=Math.min(1,2*o/n),c=g=>n*(Uy-(Uy-GA)*l*(1-Math.sin(Math.PI*Math.min(1,Math.max(0,g))**.7)**.8)-.06*g),h=g=>{let[m,y]=g>0?[t,r]:[e,r.clone().negate()],[S]=s.flatMap(b=>[b.from,b.to]).sort((b,A)=>b.distanceTo(m)-A.distanceTo(m));return S!==void 0&&S.clone().sub(m).dot(y)>.3*n*y.length()},u=(g,m)=>Array.from({length:4},(y,S)=>{let b=Math.PI/2*(g<0?S/4:1-(S+1)/4);return[m*Math.sin(b),g*(o+(h(g)?.95*n:.6*m)*Math.cos(b))]}),d=[...u(-1,c(0)),...Array.from({length:15},(g,m)=>[c(m/14),o*(m/7-1)]),...u(1,c(1))];if(i("casing",tn(d),a),o<.25*n)return;let[f,p]=[.16,.16+.06*n/(2*o)],x=[f,p].map(g=>[c(g)+.02*n,o*(2*g-1)]);i("ring",tn([[c(f),x[0][1]],x[0],x[0],x[1],x[1],[c(p),x[1][1]]]),a)}var qA=({axis:i},e)=>Hy(new E(...i),e)!==null;function Hy(i,e){let{rods:t,before:n}=e,s=t.find(({from:r,to:o,radius:a})=>Math.abs(o.clone().sub(r).normalize().dot(i))>Fy&&r.clone().cross(i).length()<.3*a);if(s)return{z:s.from.dot(i)+Math.sign(s.to.clone().sub(s.from).dot(i))*-.1*s.radius,radius:.7*s.radius};if(!n||n.trunk)return null;for(let{from:r,to:o,radius:a}of Yu(e,[n])){let l=o.clone().sub(r).normalize().dot(i),[c,h]=o.length()>1.5*a?[-.45,.56]:[.55,.64];if(Math.abs(l)>Fy)return{z:o.dot(i)-Math.sign(l)*c*a,radius:h*a}}return null}function YA(i,e,t){if(e.kind!=="revolute")return;let n=new E(...e.axis).normalize(),s=Hy(n,t);if(s){let[u,d]=[s.radius*1.06,.13*s.radius];i("joint",tn([[0,-d],[u*.94,-d],[u,-.6*d],[u,.6*d],[u*.94,d],[0,d]]),$i(n,n.clone().multiplyScalar(s.z)));return}let r=Yu(t,[t.before,...t.rods.length?[]:t.after]),{room:o,along:a}=qp(n,[...r,...t.rods]);if(o<Vy)return;ZA(i,n,qp(n,r),qp(n,t.rods));let l=o+zy,[c,h]=t.crossed?[.6*l,.79*l]:[.76*l,.64*l];Wy(i,$i(n,n.clone().multiplyScalar(a)),c,h)}function Wy(i,e,t,n){let s=l=>l.map(([c,h])=>[c,-h]),r=[[.66*t,n],[.66*t,n],[.88*t,n],[.88*t,n],[t,n-.12*t],[t,n-.12*t]],o=[[0,n-.1*t],[.5*t,n-.1*t],[.58*t,n-.05*t],[.58*t,n-.05*t],[.6*t,n-.2*t]],a=[[.6*t,n-.2*t],[.6*t,n],[.6*t,n],[.7*t,n+.012*t],[.7*t,n+.012*t],[.72*t,n-.05*t]];i("joint",tn([...s(r),...r.toReversed()],28),e);for(let[l,c]of[["casing",o],["ring",a]])i(l,tn(s(c)),e),i(l,tn(c.toReversed()),e)}function qp(i,e){let t=s=>Math.max(-1,...e.map(r=>-Xu(r,s*i.x,s*i.y,s*i.z))),n={room:t(0),along:0};for(let s=-.3;s<=.3;s+=.01)t(s)>n.room/.75+.001&&Object.assign(n,{room:t(s),along:s});return n}function ZA(i,e,t,n){let s=Math.abs(t.along-n.along),r=Math.min(t.room,n.room);if(r<Vy||s<r||s>t.room+n.room+zy)return;let o=.5*r;i("joint",tn([[o,-s/2],[o,s/2]]),$i(e,e.clone().multiplyScalar((t.along+n.along)/2)))}function $y(i,e,t,n){let s=new Le().extractRotation(yl(e)),r=Yp(i,yl(s)),o=new kt;for(let{from:c,to:h,radius:u}of r)for(let d of[c,h])o.expandByPoint(d.clone().addScalar(u)).expandByPoint(d.clone().addScalar(-u));let a=o.getCenter(new E),l=o.getSize(new E).multiplyScalar(.5).multiply(new E(...t));return{linkFromShell:s.clone().setPosition(a.clone().applyMatrix4(s)),box:l,edge:n*Math.min(l.x,l.y,l.z),rods:Yp(r,new Le().makeTranslation(a.negate()))}}var qu=[-Math.PI,Math.PI],jA=i=>[-i,i],Xy=i=>[i+.04,2*Math.PI-i-.04];function qy(i,e,t,n){i("joint",$p(e,n,qu,[-1,1],Math.PI/12));for(let[s,r]of t)i("casing",$p(e,0,s,r,Math.PI/15))}function KA(i,{rods:e,worldFromLink:t}){let n=$y(e,t,[.94,.9,.95],.5);return n.rods.some(s=>Xu(s,0,0,0)<-.5*s.radius)?(qy(i,n,[[jA(.75),[-.62,.5]],[Xy(.75),[-.62,.5]],[qu,[.53,1]]],.008),!0):!1}function JA(i,e,t){let n=e.radius,s=$y([e],t,[.84,.72,.8],.62);qy(i,s,[[qu,[.5,1]],[Xy(.95),[-.3,.48]],[qu,[-1,-.32]]],.01);for(let r of[-.26,.26]){let o=new E(s.box.x-.012,r*n,.12*n).applyMatrix4(s.linkFromShell);i("ring",tn([[.13*n,-.01],[.13*n,0],[.1*n,.008],[0,.009]],18),$i(new E(1,0,0).transformDirection(s.linkFromShell),o))}}function QA(i,e,t,n){let s=o=>Math.abs(new E().setFromMatrixPosition(At(e.pose)).applyMatrix4(t).z-o)<.1*o;if(e.kind!=="sphere"||!t||!s(e.radius))return i("casing",Bi(e,n).clone(),At(e.pose));let r=new E(0,1,0).transformDirection(yl(t));Wy(i,$i(r,new E().setFromMatrixPosition(At(e.pose))),.9*e.radius,.42*e.radius)}var eR=i=>({body:i,arm:i,joint:i,ring:i,handle:i,collision:i,tool:i,coloured:()=>i});function Yy(i,e,t,n,s,...r){let o=new vl(i,e,eR(new On({color:n,transparent:!0,opacity:.22,depthWrite:!1,polygonOffset:!0,polygonOffsetFactor:-2,polygonOffsetUnits:-2,stencilWrite:!0,stencilRef:1+s%255,stencilFunc:Cf,stencilZPass:Rf})),t);return o.show(...r),o.order=10+s,o.group}var jp=i=>!i.links.some(({visual:e})=>e);function tR(i,e){let{robot:t}=i;return t?jp(t)?Gy(i,e).map(n=>Object.entries(n).map(([s,r])=>({geometry:r,linkFromPart:new Le,look:s}))):t.links.map(({shapes:n})=>n.map(s=>({geometry:Bi(s,e),linkFromPart:At(s.pose),look:s.color??"casing"}))):[]}function Zp(i,e,t){let n=new st(i,e);return n.matrixAutoUpdate=!1,n.matrix.copy(t),n}var vl=class{constructor(e,t,n,s){this.head=e;this.meshes=t;this.materials=n;let{robot:r,tool:o}=e;this.tree=r?new vo(r.joints):null,this.parts=s?.parts??tR(e,t),this.parts.forEach((a,l)=>{let c=new ot;c.matrixAutoUpdate=!1;let h=r.links[l].arm?n.arm:n.body;for(let{geometry:u,linkFromPart:d,look:f}of a){let p=Zp(u,typeof f!="string"?n.coloured(f):f==="casing"?h:n[f],d);p.castShadow=p.receiveShadow=!s,c.add(p)}this.links.push(c),this.group.add(c)}),this.linkFromTool=At(o.solid.pose),this.tool=Zp(s?.tool.geometry??Bi(o.solid,t),n.tool,this.linkFromTool),this.tool.castShadow=!s,this.group.add(this.tool)}head;meshes;materials;group=new ot;tool;tree;links=[];collision=[];linkFromTool;parts;show(e,t,n){let s=this.tree!==null&&t.length>0;for(let a of this.links)a.visible=s;this.tree&&s&&(this.tree.update(e??[0,0,0,0,0,0,1],t),this.links.forEach((a,l)=>{a.matrix.copy(this.tree.worldFromLink[l]),a.matrixWorldNeedsUpdate=!0}));let{link:r}=this.head.tool,o=r!==null&&s?this.tree.worldFromLink[r]:void 0;this.tool.visible=o!==void 0||n!==null,o?this.tool.matrix.multiplyMatrices(o,this.linkFromTool):n&&At(n,this.tool.matrix).multiply(this.linkFromTool),this.tool.matrixWorldNeedsUpdate=!0}set collisionShown(e){e&&!this.collision.length&&this.head.robot?.links.forEach((t,n)=>{for(let s of Kp(t)){let r=Zp(Bi(s,this.meshes),this.materials.collision,At(s.pose));this.collision.push(r),this.links[n].add(r)}});for(let t of this.collision)t.visible=e}set order(e){for(let t of[this.tool,...this.links.flatMap(({children:n})=>n)])t.renderOrder=e}get toolPlace(){return new E().setFromMatrixPosition(this.tool.matrix)}get rootPlace(){return new E().setFromMatrixPosition(this.links.find(e=>e.children.length)?.matrix??new Le)}},Kp=({visual:i,shapes:e,collision:t})=>i?t??[]:e;var Zy=5,jy=1.5,bl=.07,nR=.01,Zu=class{constructor(e,t,n){this.recording=e;this.robot=t;this.still=n;n.group.updateMatrixWorld(!0)}recording;robot;still;direction=null;get from(){let{count:e,over:t}=this.still.round;return(!this.direction||!t&&this.direction.samples!==e)&&(this.direction={samples:e,from:this.findDirection()}),this.direction.from}all(e){return this.move(e),iR(Qs([...this.robot?[this.robot.group]:[],this.still.bodies]))}surface(){let e=this.surfaceCorners;if(!e.length)return this.all(0);let t=this.contacts.flatMap(n=>(this.move(n),this.robot?Qs([this.robot.tool]):[]));return[...e,...t]}at(e){let{round:t}=this.still,n=t.plan.phases.filter(({contact:d})=>d),s=n.findIndex(({end:d})=>d>e),[r,o]=[n.at(s<0?-1:s-1),s<0?void 0:n[s]],a=s===0?0:r?.end??0,l=o?.start??t.length,c=(a+l)/2;if(o&&e>=Math.max(l-jy,Math.min(c,l)))return this.stroke(o);if(r&&s!==0&&e<Math.min(a+jy,c))return this.stroke(r);let h=[a,c,l].filter(d=>t.over||d<=t.t.at(-1)),u=[r,o].flatMap(d=>d?Ky(t,d):[]);return{key:`${t.number} free ${a}`,points:[...(h.length?h:[e]).flatMap(d=>this.all(d)),...u]}}stroke(e){let t=Ky(this.still.round,e);return{key:`${this.still.round.number} stroke ${e.start}`,points:t.length?t:this.surface()}}get surfaceCorners(){return this.still.surface?Qs([this.still.surface]):[]}get contacts(){let{count:e,t,plan:n}=this.still.round,s=n.phases.filter(({contact:o,end:a})=>o&&e>0&&a<=t.at(-1)).map(({start:o,end:a})=>(o+a)/2),r=Math.max(1,s.length/Zy);return Array.from({length:Math.min(Zy,s.length)},(o,a)=>s[Math.floor(a*r)])}move(e){let{round:t}=this.still,n=this.recording.at(t.start+Math.min(e,t.length));n&&this.robot&&(this.robot.show(t.plan.root,n.q,n.tool),this.robot.group.updateMatrixWorld(!0))}findDirection(){let{plan:e}=this.still.round,t=this.contacts.map(l=>(this.move(l),{blocks:this.robot?du(this.robot.links):[],tool:this.robot?[this.robot.toolPlace,...Qs([this.robot.tool])]:[]})),n=this.surfaceCorners,s=fu(n),r=ms(e.surface,s),o=[s,...n.map(l=>l.clone().lerp(s,.15))].map(l=>l.clone().addScaledVector(r,nR)),a=this.robot&&t.length?s.clone().sub(this.robot.rootPlace):new E(.75,-1,0);return a.setZ(0).length()<.001&&a.set(1,0,0),zx(t,o,r,a.normalize().setZ(.6).normalize())}};function Ky({plan:{strokes:i,surface:e}},{stroke:t}){let n=gs(e.shape,ao(i[t??-1]??[]),!1),s=At(e.pose);return n.flatMap(r=>{let{x:o,y:a,z:l}=new E(...r).applyMatrix4(s);return Array.from({length:8},(c,h)=>new E(o+(h&1?bl:-bl),a+(h&2?bl:-bl),l+(h&4?bl:0)))})}var iR=i=>i.length?i:[new E(-.5,-.5,0),new E(.5,.5,.5)];var Ku={believed:!0,estimated:!0,actual:!0,seen:!1,path:!0,ribbon:!0,strokes:!1,rejected:!0,bases:!1,force:!0,events:!0,found:!0,actualSurface:!0,collision:!1},sr={trajectories:[],ghosts:[],frames:[],particles:[],intervals:[]},sR=9,rR=6,Jp=new E(.9,.5,1.9),Jy=1.7,Qy=1.4,oR=Math.PI-Qy-Jy*Jp.z/Jp.length(),aR={body:"body-1",arm:"arm-1",joint:"joint",ring:"ring",handle:"joint",collision:"quiet",tool:"tool"},ju=class{constructor(e,t,n){this.canvas=e;this.recording=t;this.left=n;this.painter=new zu(e);let s=a=>this.painter.software?new On:new Sa({roughness:a,metalness:.05}),r=new Map,o=a=>{let[l,c,h,u]=a,d=r.get(a.join());if(d)return d;let f=Object.assign(s(.5),u<1?{depthWrite:!1}:{});return f.userData.opacity=u,f.color.setRGB(l,c,h,jt),this.clear(f),r.set(a.join(),f),f};this.materials={body:s(.6),arm:s(.5),joint:s(.45),ring:s(.4),handle:s(.4),collision:new cn({wireframe:!0,transparent:!0,opacity:.35}),tool:new On,coloured:o,own:r},this.scene.add(this.dirt.group,this.map.mesh,this.force.group,this.marks.group,this.queried,this.highlights,this.ghosts,this.rejected.group,this.bases.group),this.camera=new Mu(e,()=>this.ask(),()=>this.leave()),e.addEventListener("webglcontextrestored",()=>this.ask()),this.paint()}canvas;recording;left;layers={...Ku};camera;painter;scene=new na;materials;seeThrough=0;ground=new st(new Fs(1,1),new Ma({opacity:.14}));sun=null;grid=null;robot=null;ghosts=new ot;current=null;entered=new Map;shown=sr;selected=null;highlights=Fn([],Et(new Xt({linewidth:8,transparent:!0,opacity:.75,depthWrite:!1}),"highlight"));queried=new ot;dirt=new Cu;map=new Lu;force=new Iu;marks=new Bu;rejected=new Hu;bases=new Wu;choice=null;begun=!1;chosen=!1;shot=null;sized=!1;apply=()=>{};first=null;moved=()=>this.draw();time=0;drawn=0;onDrawn=null;show(e){this.time=e,this.ask()}ask(){An.draw(this.moved)}resize(e,t,n){if(!(!e||!t)){if(this.apply=()=>this.applySize(e,t,n),this.sized||!this.painter.software)return this.apply();this.first??=requestAnimationFrame(()=>setTimeout(()=>{this.canvas.isConnected&&this.apply()}))}}applySize(e,t,n){this.painter.size(e,t),this.camera.shape(e,t,n),this.chosen||(this.begun=!1),this.sized=!0,this.draw()}look(e){let t=this.recording.at(this.time),n=this.current?.shots;if(!n||!t)return;this.shot=null,this.chosen=!0;let s=e==="all"?[...n.all(t.time),...this.bases.places]:n.surface();this.camera.look(pu(s,e==="above"?new E(0,-.001,1):n.from,this.camera.angles),!0),this.ask()}timeAt(e,t){let n=this.current?.path;if(!n||!(this.layers.path||this.layers.ribbon))return null;let{clientWidth:s,clientHeight:r}=this.canvas,o=n.nearest(a=>(a.project(this.camera.lens),{x:(a.x+1)/2*s,y:(1-a.y)/2*r}),e,t,this.time-n.round.start,sR,!this.layers.path);return o===null?null:n.round.start+o}get follow(){return this.shot!==null}set follow(e){this.shot=e?"":null,this.chosen=!0,this.ask()}set xray(e){this.seeThrough=e;let{body:t,arm:n,joint:s,ring:r,handle:o,own:a}=this.materials;for(let l of[t,n,s,r,o,...a.values()])this.clear(l);this.robot&&(this.robot.order=e>0?9:0),this.ask()}choose(e){this.choice=e,this.ask()}get chosenNow(){return this.choice&&this.choice.round===this.current?.still.round?this.choice:null}select(e){this.selected=e,this.lightRibbon(),this.ask()}showData(e){this.shown=e,el(this.queried);for(let t of[...Xx(e.trajectories),...ey(e.particles),...qx(e.frames)])this.queried.add(t);this.makeGhosts(),this.drawHighlights(),this.ask()}makeGhosts(){el(this.ghosts);let{head:e,meshes:t}=this.recording;if(!(!e||!this.robot))for(let[n,{time:s,color:r}]of this.shown.ghosts.entries()){let o=this.recording.at(s);o&&this.ghosts.add(Yy(e,t,this.robot,Gi(r,Me("ghost")),n,o.round.plan.root,o.q,o.tool))}}paint(){for(let[e,t]of Object.entries(aR))this.materials[e].color.set(Me(t));this.painter.paint(),this.showData(this.shown),rp(this.scene),this.dirt.paint();for(let{still:e,path:t}of this.entered.values())rp(e.group),t.paint();this.ask()}picture(){return this.draw(!0),this.canvas.toDataURL("image/png")}destroy(){An.drop(this.moved),this.camera.controls.dispose();for(let{still:e,path:t}of this.entered.values())for(let n of[e.group,t.object])eu(n);this.painter.destroy()}draw(e=!this.painter.software){let t=this.recording.at(this.time);this.sized&&(t&&this.place(t),this.sun&&(this.sun.castShadow=this.ground.visible=this.painter.hasShadows(e)),this.painter.draw(this.scene,this.camera.lens,e,()=>this.draw(!0)),this.drawn++,this.onDrawn?.())}place(e){let{head:t,meshes:n}=this.recording,{round:s,time:r}=e;!this.robot&&t&&(this.robot=new vl(t,n,this.materials),this.scene.add(this.robot.group),this.makeGhosts()),this.current?.still.round!==s&&this.enter(s);let{still:o,path:a}=this.current;this.aim(r),this.robot?.show(s.plan.root,e.q,e.tool);let l=e.phase>=0?s.plan.phases[e.phase].stroke:null,c=this.chosenNow;this.rejected.show(this.layers.rejected&&c?.rejected?c.rejected.lines:null,s.plan.surface),this.bases.show(this.layers.bases?s.plan.bases:void 0,fs()),o.show({strokes:this.layers.strokes,found:this.layers.found,actual:this.layers.actualSurface},l,this.recording.foundAt(this.time),c?.stroke??null),this.robot&&(this.robot.collisionShown=this.layers.collision),o.fade(this.camera.lens.position),a.show(r,this.layers),this.dirt.show(this.recording,this.time,e,this.layers,this.camera.pixelsPerMetre(o.surface,this.canvas.clientHeight)),this.map.show(Ru(this.recording,this.time,s,this.layers),fs()),this.marks.show(this.recording,s,r,this.layers.events,fs()),this.robot&&this.force.show(e,this.robot.toolPlace,this.camera.lens.position,this.layers.force)}enter(e){this.current&&this.scene.remove(this.current.still.group,this.current.path.object);let t=this.entered.get(e);if(!t){let n=new mu(e,this.recording);t={still:n,path:new gu(e),shots:new Zu(this.recording,this.robot,n)}}this.entered.delete(e),this.entered.set(e,t);for(let[n,{still:s,path:r}]of this.entered){if(this.entered.size<=rR)break;this.entered.delete(n);for(let o of[s.group,r.object])eu(o)}this.current=t,this.scene.add(t.still.group,t.path.object),this.drawHighlights(),this.lightRibbon()}aim(e){let t=this.current.shots;if(this.begun||(this.begun=!0,this.camera.look(pu(t.surface(),t.from,this.camera.angles)),this.grid||this.build(new kt().setFromPoints(t.all(e)).getBoundingSphere(new ln))),this.shot!==null){let{key:n,points:s}=t.at(e);n!==this.shot&&this.camera.look(pu(s,t.from,this.camera.angles),!0),this.shot=n}this.camera.step()&&this.ask()}leave(){this.chosen=!0,this.shot!==null&&(this.shot=null,this.left())}clear(e){let t=(e.userData.opacity??1)*(1-this.seeThrough);e.opacity=t,e.transparent=t<1}lightRibbon(){if(!this.current)return;let{ribbon:e,round:{start:t}}=this.current.path;e.select(this.selected&&[this.selected[0]-t,this.selected[1]-t])}drawHighlights(){let e=this.current?.path;nl(this.highlights,e?this.shown.intervals.flatMap(({start:t,end:n})=>e.between(t-e.round.start,n-e.round.start)):[])}build({center:e,radius:t}){let n=2*Math.min(60,Math.max(6,Math.ceil(3*t)));this.grid=new Na(n/2,n),this.grid.rotation.x=Math.PI/2,this.grid.position.set(Math.round(e.x),Math.round(e.y),0),Et(Object.assign(this.grid.material,{vertexColors:!1,transparent:!0,opacity:.7}),"rule"),this.ground.scale.setScalar(n/2),this.ground.position.set(this.grid.position.x,this.grid.position.y,-.001),this.ground.receiveShadow=!0;let s=new Pa(16777215,Jy);s.position.copy(e).addScaledVector(Jp,2*t),s.target.position.copy(e),this.sun=s,s.shadow.mapSize.set(this.painter.shadowSize,this.painter.shadowSize),s.shadow.bias=-5e-4,s.shadow.normalBias=.01,s.shadow.intensity=.4,s.shadow.radius=4,Object.assign(s.shadow.camera,{left:-1.4*t,right:1.4*t,top:1.4*t,bottom:-1.4*t,near:.1,far:9*t});let r=new Aa(16777215,9080728,Qy);r.position.set(0,0,1),this.scene.add(this.grid,this.ground,s,s.target,r,new Ia(16777215,oR));for(let[o,a]of[[[1,0,0],"axis-x"],[[0,1,0],"axis-y"],[[0,0,1],"axis-z"]])this.scene.add(Fn([0,0,.002,...o.map(l=>.25*l)],Et(new Xt({linewidth:2.5}),a)))}};var lR=.95,cR=([i,e],[t,n])=>i<=n+jh&&e>=t-jh;function Ms({about:i,view:e},t){let n=new Map,s=o=>n.set(o,(n.get(o)??0)+1),r=t===null?i:[i[t]??[]];for(let o of r)for(let a of new Set(o.map(({episode:l})=>l)))s(a);if(t===null&&e)for(let{episode:o}of[...e.tracks,...e.bodies,...e.particles])s(o);return[...n].sort((o,a)=>a[1]-o[1]).map(([o])=>o)}function Ju(i,e,t,n){let s=i.view,r=s?.episodes.find(h=>h.id===t),o={...structuredClone(sr),since:[]};if(!s||!r)return o;let a=h=>dR(n,r.rounds??[r.interval[0]],h),l=uR(e===null?i.about.flat():i.about[e]??[],t,r.interval);for(let{interval:h,class:u}of l)h&&o.intervals.push({start:a(h[0]),end:a(h[1]),label:hR(u)});let c=h=>e===null||!l.length||l.some(u=>u.interval&&cR(u.interval,h));for(let{episode:h,thing:u,interval:d,path:f,samples:p,strong:x,colour:g}of s.tracks){if(h!==t||!c(d))continue;let m=`${em(u)} ${Je(a(d[0]))} to ${Je(a(d[1]))}`,y=p.map(([,S,b,A])=>[S,b,A]);o.trajectories.push({name:m,points:f.length>1?f:y,samples:y,...Qp(x,g)})}for(let{episode:h,thing:u,kind:d,time:f,pose:p,strong:x,colour:g}of s.bodies)h!==t||!c([f,f])||(d==="robot"||d==="tool"?o.ghosts.push({time:a(f),...Qp(x,g)}):o.frames.push({name:`${em(u)} at ${Je(a(f))}`,time:a(f),pose:p,...Qp(x,g)}));for(let{episode:h,round:u,state:d,positions:f,colour:p}of s.particles){let x=n.rounds.find(b=>b.number===u),g=r.rounds?.[u-1]??r.interval[0];if(h!==t||!x||!c([g,g+x.length]))continue;let m=d==="before",y=`${m?"dirt before":"estimated dirt after"} round ${u}, as queried`,S=(m?null:x.interpreted?.found)??x.plan.surface.pose;o.particles.push({name:y,state:d,pose:S,shape:x.plan.surface.shape,places:f,...p?{color:p}:{}}),o.since.push(m?x.start:x.end)}if(o.ghosts=[...new Map(o.ghosts.map(h=>[h.time,h])).values()].sort((h,u)=>h.time-u.time),!o.intervals.length)for(let[h,u]of r.shown)o.intervals.push({start:a(h),end:a(u),label:"shown"});return o}var Qp=(i,e)=>e?{color:e}:i?{color:Me("highlight")}:{},hR=i=>ja(i.replace(/([a-z])(?=[A-Z])/g,"$1 ")).toLowerCase();function uR(i,e,[t,n]){let s=new Set;return i.filter(({episode:r,interval:o,class:a})=>{if(r!==e||!o)return!1;let l=`${a} ${o.join()}`;return s.has(l)||o[1]-o[0]>lR*(n-t)?!1:(s.add(l),!0)})}function dR(i,e,t){let n=e.findLastIndex(r=>r<=t+jh);n=Math.max(0,n);let s=i.rounds.find(({number:r})=>r===n+1)??i.rounds.at(-1);return s?Math.min(s.end,Math.max(s.start,s.start+t-e[n])):0}function Qu(i,e){i.show(e);let{ghosts:t,frames:n,intervals:s,since:r}=e,o=[[...t,...n].map(({time:a})=>a),s.map(({start:a})=>a),r].find(a=>a.length);o&&i.seek(Math.min(...o))}var em=i=>i.replace(/^[a-z]+:/,""),tm=i=>/\d{8}-\d{6}-[0-9a-f]{4}/.exec(i)?.[0]??null,fR=i=>/(?:^|, )(?:human )?collision(?: \d+)?$/i.test(i)?ja(i):i,nm=({names:i},e)=>Object.hasOwn(i,e)?fR(i[e]):em(e).replace(/_(\d{8}-\d{6}-[0-9a-f]{4})-(\d+)$/," $2"),im=i=>new Date(1e3*i).toLocaleString("en-GB",{day:"numeric",month:"short",hour:"2-digit",minute:"2-digit"}),sm=({task:i,begun:e})=>`${i}, ${im(e)}`;var rm=200,pR=8,mR=3,gR=1e9,xR=1e10,ev={share:["%",100],rad:["\xB0",180/Math.PI],m:["mm",1e3],"m per episode":["mm per episode",1e3]};function _l(i){let{view:e,about:t}=i;return!!e&&Ms(i,null).length>0&&(e.tracks.length>0||e.bodies.length>0||e.particles.length>0||t.some(n=>n.some(({interval:s})=>s)))}function ed(i,e){let{rows:t,columns:n,holds:s,more:r,seconds:o,printed:a,remarks:l,view:c,about:h}=i,u=s?`${t.length}${r?" or more":""} ${t.length===1?"answer":"answers"}`:"No answer: false",d=[M("p",{class:"s-count"},M("b",{},u),o===void 0?"":` in ${Be(o,2)} s`)];if(_l(i)){d.push(M("div",{class:"s-row"},M("button",{class:"w-button",type:"button",click:()=>e.show(i,null,null)},"Show all"),M("button",{class:"w-button",type:"button",click:()=>e.clear()},"Clear")));let p=Ms(i,null);p.length>1&&d.push(M("div",{class:"s-in"},M("span",{class:"w-quiet"},"in "),...p.slice(0,pR).map(x=>M("button",{class:"s-chip",type:"button",title:x,click:()=>e.show(i,null,x)},yR(i,x)))))}let f=c?.left_out??0;f&&d.push(M("p",{class:"w-quiet s-remark"},`The picture is full: ${f} more queried ${f===1?"object is":"objects are"} not drawn.`));for(let p of l)d.push(M("p",{class:"w-quiet s-remark"},p));a&&d.push(M("pre",{class:"s-printed"},a));for(let p of c?.plots??[])d.push(jx(p,vR(i,p)));return t.length&&n.length?d.push(bR(i,e)):t.length&&h.every(p=>!p.length)&&d.push(M("p",{},"True.")),t.length>rm&&d.push(M("p",{class:"w-quiet"},`The table lists the first ${rm} of ${t.length} answers.`)),d}var tv=({about:i},e)=>i.flat().find(({episode:t})=>t===e),yR=(i,e)=>{let t=tv(i,e);return t?sm(t):e};function vR(i,{amounts:e=[],spans:t=[]}){let n=new Set([...e,...t].map(([s])=>tm(s)).filter(s=>s!==null));return s=>{let[r,o]=[tm(s),nm(i,s)];if(r===null||n.size<2)return o;let a=tv(i,r);return`${o}
${a?`${im(a.begun)}, ${a.task}`:r}`}}function bR(i,e){let{rows:t,columns:n,units:s,about:r}=i,o=n.map((h,u)=>s[u]?`${h} [${ev[s[u]]?.[0]??s[u]}]`:h),a=r.some(h=>h.length>0),l=[M("span",{class:"w-hidden"},"show"),...o,...a?["Episode"]:[]],c=t.slice(0,rm).map((h,u)=>{let d=r[u]??[],f=[...h.map((p,x)=>wR(i,p,s[x]??null)),...a?[_R(d)]:[]];return f.forEach((p,x)=>p.setAttribute("data-title",o[x]??"Episode")),M("tr",{},M("td",{},d.length?M("button",{class:"w-button s-show",type:"button","data-row":u,"aria-label":`Show answer ${u+1}`,click:()=>e.show(i,u,null)},"Show"):""),...f)});return M("div",{class:`s-table${n.length>mR?" s-stacks":""}`,tabindex:0,role:"group","aria-label":"Answers"},Mi(l,c))}function _R(i){let e=new Map(i.map(t=>[t.episode,sm(t)]));return M("td",{title:[...e.keys()].join(", ")},[...e.values()].join("; "))}function wR(i,e,t){if(typeof e=="number"){let s=!t&&e>=gR&&e<xR,[,r]=ev[t??""]??["",1],o=s?MR(e):Number.isInteger(e)&&!t?String(e):t==="share"?Be(r*e,1):String(Number((r*e).toPrecision(t?3:5)));return M("td",{class:"s-number",title:`${e}${t&&t!=="share"?` ${t}`:""}`},o.replace("-","\u2212"))}if(e===null)return M("td",{class:"w-quiet"},"_");let n=nv(i,e);return M("td",{title:typeof e=="string"?e:n},n)}var nv=(i,e)=>e===null?"_":Array.isArray(e)?`[${e.map(t=>nv(i,t)).join(", ")}]`:typeof e=="number"?String(Number(e.toPrecision(6))):nm(i,e),MR=i=>{let e=new Date(1e3*i);return`${e.toLocaleTimeString("en-GB")}.${String(e.getMilliseconds()).padStart(3,"0")}`};var bo=[.1,.25,.5,1,2,5,10],SR=1.15,om={least:.12,most:.8},TR=3,ER=300;function td(i,e){let t,n=i.subscribe(({playing:s,following:r})=>{clearTimeout(t),!s&&!r&&(t=setTimeout(()=>e(i.time),ER))});return()=>{clearTimeout(t),n()}}var _o=class{constructor(e=An){this.pictures=e}pictures;time=0;playing=!1;following=!1;speed=1;spans=new Set;callbacks=new Set;frame=null;before=0;late=0;known={edge:0,since:0,every:om.least,pace:0};join(e){return this.spans.add(e),()=>{this.spans.delete(e)}}get duration(){return Math.max(0,...[...this.spans].map(e=>e.duration))}get end(){return Math.max(0,...[...this.spans].map(e=>e.now))}get edge(){let e=[...this.spans].filter(t=>t.live);return e.length?Math.max(0,...e.map(t=>t.now)):this.end}get isLate(){return this.playing&&this.late>1}get live(){return[...this.spans].some(e=>e.live)}subscribe(e){return this.callbacks.add(e),()=>this.callbacks.delete(e)}onGrowth(){this.following&&!this.live&&(this.following=!1,this.time=this.end),this.following&&(this.keepPace(),this.run()),this.notify()}seek(e){this.following=!1,this.time=Math.min(this.duration,Math.max(0,Number.isFinite(e)?e:0)),this.notify()}play(){if(this.time>=this.end-1e-6){if(this.live)return this.follow();this.time=0}this.playing=!0,this.following=!1,this.run(),this.notify()}pause(){this.playing=!1,this.following=!1,this.notify()}toggle(){this.playing||this.following?this.pause():this.play()}follow(){this.following=!0,this.playing=!1,this.known={edge:-1,since:this.pictures.now(),every:om.least,pace:0},this.keepPace(),this.run(),this.notify()}setSpeed(e){this.speed=Math.min(10,Math.max(.1,e)),this.notify()}faster(e){let t=bo.reduce((n,s,r)=>Math.abs(s-this.speed)<Math.abs(bo[n]-this.speed)?r:n,0);this.setSpeed(bo[Math.min(bo.length-1,Math.max(0,t+e))])}destroy(){this.frame!==null&&this.pictures.cancel(this.frame),this.frame=null,this.callbacks.clear()}run(){this.frame===null&&(this.before=this.pictures.now(),this.late=0,this.frame=this.pictures.request(e=>this.step(e)))}step(e){this.frame=null;let t=Math.max(0,(e-this.before)/1e3);this.late=t>TR?this.late+1:0;let n=this.late?.25:t;if(this.before=Math.max(this.before,e),this.following){let{edge:r}=this,o=r-this.time,a=n*this.known.pace;this.time=Math.abs(o)<=Math.max(.001,a)?r:this.time+Math.sign(o)*a}else this.playing&&(this.time=Math.min(this.end,this.time+n*this.speed),this.time>=this.end&&(this.playing=!1,this.live&&this.follow()));(this.playing||this.following&&this.edge!==this.time)&&(this.frame=this.pictures.request(r=>this.step(r))),this.notify()}keepPace(){let{edge:e,known:t}=this;if(e===t.edge)return;let n=this.pictures.now(),{least:s,most:r}=om,o=Math.min(r,Math.max(s,(n-t.since)/1e3)),a=t.edge<0?s:t.every+.3*(o-t.every);this.known={edge:e,since:n,every:a,pace:Math.abs(e-this.time)/(SR*a)}}notify(){for(let e of this.callbacks)e(this)}};var AR=.9;function nd(i){let{plan:{treatment:e},interpreted:t,truth:n}=i;return bn(i)?!!(vn(e,t?.treated)&&vn(e,n?.treated)):!!(t&&n?.particles)}function RR(i){let e=i.filter(r=>r>0).sort((r,o)=>o-r),t=AR*e.reduce((r,o)=>r+o,0),n=0;return e.findIndex(r=>(n+=r)>=t-1e-9)+1}function CR(i,{cell:e,places:t}){let n=new Map,s=(r,o)=>Math.round((r-(t[o]??0))/(Lo*e));for(let r=0;r+1<i.length;r+=2){let o=`${s(i[r],0)} ${s(i[r+1],1)}`;n.set(o,(n.get(o)??0)+1)}return[...n.values()]}function am(i,e,t){let n=Math.abs(Math.round(e)-t);return[i,String(Math.round(e)),String(t),i.endsWith("(sample)")?"":`${n} ${n===1?"particle":"particles"}`]}function PR({plan:{goal:i},interpreted:e,truth:t}){let{particles:n,density:s}=e,r=t.particles,o=s?"":" (sample)",a=s?s.remaining??s.expected.reduce((d,f)=>d+f,0):n.length/2,l=t.remaining??r.length/2,c=r.length/2!==l||t.remaining===void 0&&r.length/2>=Np,h=[];if(i?.kind==="collected"&&!c&&(!s||s.goal!==void 0)){let d=s?.goal??Do(lt(n),i),f=Do(lt(r),i);h.push(am(`In the goal area${o}`,d,f),am(`Elsewhere on the surface${o}`,Math.max(0,a-d),l-f))}else(t.remaining!==void 0||!c)&&h.push(am(`Left on the surface${o}`,a,l));let u=d=>`${Math.round(RR(d)*s.cell**2*1e4)} cm\xB2`;return s&&!c&&a>0&&l>0&&h.push(["Area that holds 90\u202F% of the dirt",u(s.expected),u(CR(r,s)),""]),h}function IR(i){let{plan:{treatment:e},interpreted:t,truth:n}=i,s=e,r=[vn(s,t.treated),vn(s,n.treated)],{length:o}=r[0],[a,l]=[cl(s,r[0]),cl(s,r[1])],c=r.map(d=>d.reduce((f,p)=>f+p,0)/Math.max(1,o)),h=d=>s.unit==="passes"?Be(d,2):`${Be(d,1)} ${s.unit}`,u=a.filter((d,f)=>d!==l[f]).length;return[[`Mean ${_i(i)}`,h(c[0]),h(c[1]),h(Math.abs(c[0]-c[1]))],["Places whose mean is in the band",_e(hl(a,"allowed"),1),_e(hl(l,"allowed"),1),`${u} of ${o} places`]]}function lm({interpreted:i,truth:e}){let t=e?.performance??null;return!!(i&&t!==null&&(t<i.estimate.low||t>i.estimate.high))}function cm(i){let{mean:e}=i.interpreted.estimate,t=i.truth.performance??null,n=bn(i)?IR(i):PR(i);if(t===null)return n;let s=o=>Number(Be(100*o,1)),r=`${Be(Math.abs(s(e)-s(t)),1)} points, ${lm(i)?"outside":"inside"} the interval`;return[...n,["Performance",_e(e,1),_e(t,1),r]]}var LR={play:"M4 2.5v11l9.5-5.5z",pause:"M3.5 2.5h3v11h-3zM9.5 2.5h3v11h-3z",before:"M3 3h2v10H3zM13 3v10L6 8z",after:"M11 3h2v10h-2zM3 3v10l7-5z"},hm=i=>ie("svg",{viewBox:"0 0 16 16",width:14,height:14,"aria-hidden":"true",fill:"currentColor"},ie("path",{d:LR[i]})),DR={believed:()=>ie("circle",{cx:8,cy:8,r:3.2,fill:"var(--believed)"}),estimated:()=>ie("circle",{cx:8,cy:8,r:4.6,fill:"none",stroke:"var(--estimated)","stroke-width":2.4}),actual:()=>ie("path",{d:"M4 4l8 8M12 4l-8 8",fill:"none",stroke:"var(--actual)","stroke-width":2.6}),seen:()=>ie("rect",{x:3,y:3,width:10,height:10,fill:"none",stroke:"var(--seen)","stroke-width":1.8}),map:()=>ie("g",{},...["little-3","allowed-2","much-1"].map((i,e)=>ie("rect",{x:1+5*e,y:3,width:5,height:10,fill:`var(--${i})`}))),path:()=>ie("path",{d:"M1 11h6l8-6",fill:"none",stroke:"var(--contact)","stroke-width":2.4}),ribbon:()=>ie("g",{class:"w-forces"},...ro.map(({colour:i},e)=>ie("rect",{x:1+5*e,y:7-2*e,width:5,height:2+4*e,fill:`var(--${i})`}))),strokes:()=>ie("path",{d:"M1 11h6l8-6",fill:"none",stroke:"var(--stroke)","stroke-width":2}),rejected:()=>ie("path",{d:"M1 11h6l8-6",fill:"none",stroke:"var(--rejected)","stroke-width":1.2}),bases:()=>ie("path",{d:"M14.5 8L9 11.5A4.5 4.5 0 1 1 9 4.5z",fill:"var(--band-6)",stroke:"var(--quiet)","stroke-width":1.2}),force:()=>ie("path",{d:"M8 15V6M8 1l4 6H4z",fill:"var(--force)",stroke:"var(--force)","stroke-width":2}),events:()=>ie("circle",{cx:8,cy:8,r:4.5,fill:"var(--collision)",stroke:"var(--ink)","stroke-width":1.2}),found:()=>ie("path",{d:"M2 12l3-8h9l-3 8z",fill:"var(--found)","fill-opacity":.3,stroke:"var(--found)","stroke-width":2}),actualSurface:()=>ie("path",{d:"M2 12l3-8h9l-3 8z",fill:"none",stroke:"var(--actual)","stroke-width":1.6,"stroke-dasharray":"3 2"}),collision:()=>ie("path",{d:"M5 2h6l3 6-3 6H5L2 8zM5 2l6 12M11 2L5 14",fill:"none",stroke:"var(--quiet)","stroke-width":1}),"by-touch":()=>ie("path",{d:"M8 1v14M5 1h6M5 15h6",fill:"none",stroke:"var(--by-touch)","stroke-width":1.6}),interval:()=>ie("path",{d:"M8 1v14M4 1h8M4 15h8",fill:"none",stroke:"var(--estimated)","stroke-width":2.2}),target:()=>ie("path",{d:"M0 8h16",fill:"none",stroke:"var(--target)","stroke-width":2,"stroke-dasharray":"4 3"}),goal:()=>ie("circle",{cx:8,cy:8,r:5.5,fill:"var(--goal)","fill-opacity":.35,stroke:"var(--goal-line)","stroke-width":1.6})},wo=i=>ie("svg",{viewBox:"0 0 16 16",width:15,height:15,"aria-hidden":"true"},DR[i]?.()),iv=(i,e)=>ie("svg",{viewBox:"0 0 16 16",width:15,height:15,"aria-hidden":"true"},ie("path",{d:`M8 1l7 7-7 7-7-7z${e?"M8 5l3 3-3 3-3-3z":""}`,"fill-rule":"evenodd",fill:i,stroke:"#000","stroke-width":1.4}));var um=[1,3,10],sv=[.15,.85],NR=.03,rv=i=>Math.max(0,um.findLastIndex(e=>i>=e));function kR({cell:i,places:e,expected:t}){let n=lt(e),s=um.map(()=>"");return t.forEach((r,o)=>{if(!(r>0))return;let a=500*i*Math.sqrt(Math.min(1,r)),[l,c]=[1e3*n[2*o],-1e3*n[2*o+1]];s[rv(r)]+=`M${(l-a).toFixed(1)} ${(c-a).toFixed(1)}h${(2*a).toFixed(1)}v${(2*a).toFixed(1)}h${(-2*a).toFixed(1)}z`}),s.map((r,o)=>ie("path",{d:r,class:`w-density-${o+1}`}))}function ov({cell:i}){let e=t=>{let n=14*Math.sqrt(Math.min(1,t));return ie("svg",{viewBox:"0 0 14 14",width:14,height:14,"aria-hidden":"true"},ie("rect",{x:7-n/2,y:7-n/2,width:n,height:n,class:`w-density-${rv(t)+1}`}))};return M("li",{},`estimate: expected particles per ${Math.round(1e3*i)} mm cell:`,...[.1,.5,...um].flatMap((t,n,s)=>[e(t),`${n===s.length-1?"\u2265\u202F":""}${t}`]))}var id=class{element=M("figure",{class:"w-seam"});table=M("div",{class:"w-compared"});share=null;chosen=null;rounds=[];show(e){this.rounds=e.filter(nd);let t=this.rounds.find(({number:n})=>n===this.chosen)??this.rounds.at(-1);return this.table.replaceChildren(this.makeTable(t)),this.element.replaceChildren(...this.draw(t)),this.element}draw(e){let{interpreted:t,truth:n,number:s}=e,r=bn(e)?e.plan.treatment:null,[o,a,l]=[ai(),ai(),ai()],c=(D,...P)=>ie("g",{"clip-path":`url(#${D})`,class:"w-map"},...P),h=r?null:t.density??null,u=r?{id:o,map:ie("g",{"clip-path":`url(#${o})`},c(a,...Nu(r,vn(r,t.treated))),c(l,...Nu(r,vn(r,n.treated))))}:null,d=r?[]:[...h?[]:[{mark:"estimated",places:lt(t.particles)}],{mark:"actual",places:lt(n.particles)}],f=cm(e).map(([D,P,k])=>`${D}: ${P} estimated, ${k} true.`),p=`${Yi(uo(e))} at the end of round ${s}: estimated left of the seam, true right of it. ${f.join(" ")}`,x=Hi(e,d,p,u);h&&x.querySelector(".w-dots")?.before(c(a,...kR(h))),x.querySelector(".w-dots-estimated")?.setAttribute("clip-path",`url(#${a})`),x.querySelector(".w-dots-actual")?.setAttribute("clip-path",`url(#${l})`);let[g,m,y,S]=x.getAttribute("viewBox").split(" ").map(Number);this.share??=r?.5:OR(lt(n.particles),g/1e3,y/1e3);let[b,A]=[a,l].map(D=>ie("clipPath",{id:D},ie("rect",{y:m,height:S}))),R=ie("path",{class:"w-seam-line","vector-effect":"non-scaling-stroke"});x.append(b,A,R);let v=M("input",{type:"range",min:0,max:1,step:.01,"aria-label":"Seam between estimate and truth",input:()=>T(Number(v.value))}),T=D=>{this.share=D;let P=g+D*y;for(let[k,O,z]of[[b,g,P],[A,P,g+y]])k.firstElementChild.setAttribute("x",String(O)),k.firstElementChild.setAttribute("width",String(z-O));R.setAttribute("d",`M${P} ${m}v${S}`),v.setAttribute("aria-valuetext",`${_e(D)} of the width shows the estimate, the rest the truth`)};return this.element.style.setProperty("--ratio",(y/S).toFixed(4)),v.value=String(this.share),T(Number(v.value)),[M("div",{class:"w-seam-picture"},x,v),M("figcaption",{},M("span",{},`\u25C2 Estimated${r?" mean":""}`),M("span",{},"True \u25B8"),this.makeChoice(e))]}makeChoice(e){let t="End of round";return this.rounds.length===1?M("p",{class:"w-rounds"},`${t} ${e.number}`):M("div",{class:"w-rounds",role:"group","aria-label":t},t,...this.rounds.map(({number:n})=>M("button",{type:"button",class:"w-button","aria-pressed":String(n===e.number),click:()=>{this.chosen=n,this.show(this.rounds),this.element.querySelector("[aria-pressed=true]")?.focus()}},String(n))))}makeTable(e){return Mi([`End of round ${e.number}`,"Estimated","True","Off by"],cm(e).map(([t,...n])=>Rl(t,n)))}};function OR(i,e,t){let n=Array.from({length:i.length/2},(r,o)=>i[2*o]).sort((r,o)=>r-o),s=n[n.length>>1];return s===void 0?.5:Math.min(sv[1],Math.max(sv[0],(s-e)/t-NR))}var dm={believed:"believed before",estimated:"estimated after",actual:"true after",seen:"observed",sample:"estimated after: a typical sample",interval:"90\u202F% interval","by-touch":"from touch only",target:"target",goal:"goal area"},wl=i=>M("ul",{class:"w-legend"},...i.map(e=>M("li",{},wo(e==="sample"?"estimated":e),dm[e]))),UR=6,FR=i=>i===null?"":` Predicted performance: ${_e(i)}.`;function BR(i){let e=M("button",{type:"button",class:"w-button",click:()=>{(navigator.clipboard?navigator.clipboard.writeText(i):Promise.reject()).then(()=>ze(e,"Copied"),()=>ze(e,"Not copied"))}},"Copy");return M("div",{class:"w-command"},M("code",{},i),e)}function zR(i){let e=(i.interpreted?.incidents??[]).map(t=>({...t,title:ja(t.title)}));return lm(i)?[...e,{time:null,title:"The ground truth lies outside the interval of the estimate",evidence:`Estimated ${Gt(i.interpreted.estimate,1)}, true ${_e(i.truth.performance,1)}.`,effect:"A correct 90\u202F% interval misses the ground truth in one of ten rounds. The ground truth is known only in simulation.",advice:""}]:e}var Mo=class{constructor(e,t,n){this.recording=e;this.seek=t;this.element=M("header",{class:"w-story"},M("div",{class:"w-top"},this.title,this.badge,n),M("div",{class:"w-told"},this.pictures,this.texts,this.incidents)),this.destroy=vu(e,()=>this.show()),this.show()}recording;seek;element;title=M("h1",{});badge=M("p",{class:"w-badge"});pictures=M("div",{class:"w-pictures"});texts=M("div",{class:"w-texts"});seam=new id;comparison=M("div",{class:"w-comparison"});incidents=M("section",{class:"w-incidents","aria-label":"Incidents"});destroy;show(){let{head:e,ended:t,rounds:n,stages:s,live:r}=this.recording,o=n.findLast(p=>p.interpreted)??null;ze(this.title,e?.title||"Recording");let{state:a,text:l}=po(this.recording),[c,h]=[a==="planned",a==="logged"];this.badge.dataset.state=a,ze(this.badge,l);let u=t?.story,d=u?.happened??(r?s.at(-1)?.words??"The run is starting.":o?`The run ended early after round ${o.number}: ${o.interpreted.verdict}.`:c?`Planned, not executed.${FR(n.at(-1).plan.predicted)}`:h?Uu:n.length?"The recording ends before the first round has a result.":"The recording has no rounds."),f=n.map(({number:p,interpreted:x,truth:g})=>[p,x?.estimate,x?.by_touch,g?.performance]);jn(this.texts,[e?.task,u,r,d,a,f])&&this.texts.replaceChildren(...this.makePart("Task",u?.asked??e?.task?.asked??""),...this.makePart(r?"Now":"Result",d),...this.makePart("Confidence",u?.sure??(o||c||h?"":"No round has a result yet."),this.drawBars()),this.comparison,...this.makePart("More certainty",u?.surer??""),...this.makePart("Next",u?.next?.words??"",u?.next?.command?BR(u.next.command):null)),this.drawPictures(),this.showIncidents()}showIncidents(){let e=this.recording.rounds.flatMap(o=>zR(o).map(a=>({round:o,incident:a}))),t=this.recording.rounds.some(o=>o.interpreted?.incidents),n=e.slice(0,UR),s=e.length-n.length;this.incidents.hidden=!t&&!e.length;let r=[s,n.map(({round:{number:o,start:a},incident:l})=>[o,a,l])];jn(this.incidents,r)&&this.incidents.replaceChildren(M("h2",{},"What did not go as planned"),...e.length?[M("ul",{},...n.map(({round:o,incident:a})=>this.makeCard(o,a))),...s?[M("p",{class:"w-quiet"},`and ${s} more`)]:[]]:[M("p",{class:"w-quiet"},"Nothing unusual was detected.")])}makeCard(e,{time:t,title:n,evidence:s,effect:r,advice:o}){let a=`Round ${e.number}${t===null?"":` \xB7 ${Je(e.start+t)}`}`;return M("li",{"data-round":e.number},M("button",{type:"button",class:"w-when",title:"Show this time",click:()=>this.seek(e.start+(t??0))},a),M("h3",{},n),...[s,r].filter(l=>l).map(l=>M("p",{},l)),o?M("p",{class:"w-advice"},o):null)}makePart(e,t,n=null){if(!t&&!n)return[];let s=[M("h2",{},e)];return t&&s.push(M("p",{},t)),n&&s.push(n),s}drawPictures(){let{rounds:e,before:t}=this.recording,n=e[0],s=e.findLast(a=>a.interpreted??a.truth)??null,r=e.map(({plan:a,interpreted:l,truth:c,observed:h})=>[a.round,a.predicted,a.duration,!!l,!!c,!!h]);if(!jn(this.pictures,[r,!!t.observed]))return;let o=s&&nd(s)?this.seam.show(e):null;this.comparison.replaceChildren(...o?this.makePart("Ground truth","",this.seam.table):[]),this.pictures.toggleAttribute("data-maps",!!(n&&bn(n))),this.pictures.replaceChildren(...n?bn(n)?hy(this.recording,o):this.makeDirtFigures(n,s,o):[])}makeDirtFigures(e,t,n){let{observed:s}=this.recording.before,r=e.plan.goal?.kind==="collected"?["goal"]:[],o=[{mark:"believed",places:e.particles.first}];s&&o.push({mark:"seen",places:lt(s.detections)});let a=e.plan.surface.shape,l=(u,d,f)=>nr(Hi(d,f,`${u}: ${uo(d)} with ${f.map(({places:p,mark:x})=>`${p.length/2} particles ${dm[x]}`).join(", ")}`),a?`${u}, surface unrolled`:u),c=(...u)=>[...new Set(u.map(({mark:d})=>d)),...r];if(!t){if(e.plan.kind!=="planned")return[l("Believed before",e,o),wl(c(...o))];let u=[{mark:"believed",places:e.particles.last}];return[l("Before",e,o),this.drawArrow(),l("Predicted",e,u),wl(c(...o,...u))]}if(n){let u=t.interpreted?.density,d=wl([...c(...o),...u?[]:["sample"],"actual"]);return u&&d.append(ov(u)),[l("Before",e,o),this.drawArrow(),n,d]}let h=[];return t.interpreted&&h.push({mark:"estimated",places:lt(t.interpreted.particles)}),t.truth?.particles&&h.push({mark:"actual",places:lt(t.truth.particles)}),t.observed&&h.push({mark:"seen",places:lt(t.observed.detections)}),[l("Before",e,o),this.drawArrow(),l(`After ${t.number} ${t.number===1?"round":"rounds"}`,t,h),wl(c(...o,...h))]}drawArrow(){return ie("svg",{viewBox:"0 0 24 24",class:"w-arrow","aria-hidden":"true"},ie("path",{d:"M3 12h16M13 6l6 6-6 6"}))}drawBars(){let{rounds:e,head:t}=this.recording,n=e.filter(l=>l.interpreted).slice(-8);if(!n.length)return null;let s=t?.task?.target??null,r=n.map(({number:l,interpreted:c,truth:h})=>{let{estimate:u,by_touch:d}=c,f=h?.performance??null,p=y=>`${(1.5+97*Math.min(1,Math.max(0,y))).toFixed(2)}%`,x=(y,S)=>`${Math.max(.6,97*(Math.min(1,S)-Math.max(0,y))).toFixed(2)}%`,g=(y,S,b,A)=>ie("line",{x1:p(y),x2:p(y),y1:S,y2:b,...A}),m=`Round ${l}: estimated ${_e(u.mean)}, 90 % interval ${_e(u.low)} to ${_e(u.high)}; from touch only ${Gt(d)}${f===null?"":`; true ${_e(f)}`}${s===null?"":`; target ${_e(s)}`}`;return M("div",{class:"w-bar"},M("span",{},`Round ${l}`),ie("svg",{role:"img","aria-label":m},ie("rect",{x:p(0),y:8,width:"97%",height:10,rx:5,fill:"var(--lane)"}),ie("rect",{x:p(d.low),y:21.5,width:x(d.low,d.high),height:2,fill:"var(--by-touch)"}),ie("rect",{x:p(u.low),y:6,width:x(u.low,u.high),height:14,rx:4,fill:"var(--estimated)","fill-opacity":.35,stroke:"var(--estimated)","stroke-width":1.6}),g(u.mean,4,22,{stroke:"var(--estimated)","stroke-width":3}),s!==null&&g(s,0,26,{stroke:"var(--target)","stroke-width":2,"stroke-dasharray":"4 3"}),f!==null&&ie("svg",{x:p(f),y:13,overflow:"visible"},ie("path",{d:"M-5 -5L5 5M5 -5L-5 5",stroke:"var(--actual)","stroke-width":2.6,fill:"none"}))),M("b",{},_e(u.mean)))}),o=n.some(({truth:l})=>typeof l?.performance=="number"),a=wl(["interval","by-touch",...o?["actual"]:[],...s===null?[]:["target"]]);for(let l of a.children)l.textContent===dm.actual&&(l.lastChild.textContent="true");return s!==null&&(a.lastElementChild.lastChild.textContent=`target ${_e(s)}`),M("div",{class:"w-bars"},...r,a)}};var lv=["video/webm;codecs=vp8","video/webm"],VR=5e6,GR=1500,HR=100,WR=3.1,$R=.05,sd=34,av=15;function XR(){return typeof MediaRecorder>"u"||!("captureStream"in HTMLCanvasElement.prototype)?"This browser cannot record video: it has no MediaRecorder for a canvas.":lv.some(i=>MediaRecorder.isTypeSupported(i))?null:"This browser cannot record WebM video."}var fm=class{constructor(e,t,n,s,r,o){this.stage=e;this.recording=t;this.clock=n;this.from=s;this.to=r;this.speed=o;let{clientWidth:a,clientHeight:l}=e.canvas,c=u=>2*Math.round(u*this.ratio/2);Object.assign(this.canvas,{width:c(a),height:c(l+2*sd)});let h=this.canvas.captureStream(0);this.track=h.getVideoTracks()[0],this.recorder=new MediaRecorder(h,{mimeType:lv.find(u=>MediaRecorder.isTypeSupported(u)),videoBitsPerSecond:VR}),this.recorder.addEventListener("dataavailable",({data:u})=>this.chunks.push(u))}stage;recording;clock;from;to;speed;canvas=M("canvas");pen=this.canvas.getContext("2d");ratio=Math.min(2,devicePixelRatio||1);chunks=[];recorder;track;begun=0;isRunning=!1;start(e){this.recorder.addEventListener("start",()=>{this.begun=performance.now(),this.isRunning=!0,e()}),this.recorder.start(1e3),this.draw()}draw(){let{canvas:e,pen:t,clock:n,recording:s,ratio:r}=this,o=s.at(n.time),a=sd*r;t.fillStyle=Me("scene"),t.fillRect(0,0,e.width,e.height),t.drawImage(this.stage.canvas,0,a,e.width,e.height-2*a);let l=s.resultAt(n.time)?.interpreted,c=l?`Estimated ${Gt(l.estimate)}`:typeof o?.performance=="number"?`Predicted ${_e(o.performance)}`:"",h=`${Je(n.time)} / ${Je(n.duration)}${this.speed===1?"":` \xB7 ${this.speed}\xD7`}`;this.write(0,s.head?.title||"Recording",h),this.write(e.height-a,o?`Round ${o.round.number} of ${s.rounds.length} \xB7 ${Bp(s,o)}`:"",c),this.track.requestFrame()}write(e,t,n){let{canvas:s,pen:r,ratio:o}=this,[a,l]=[12*o,e+(sd/2+.36*av)*o];r.fillStyle=Me("paper"),r.fillRect(0,e,s.width,sd*o),r.fillStyle=Me("ink"),r.font=`600 ${av*o}px system-ui, sans-serif`;let c=Math.min(r.measureText(n).width,s.width/2);r.fillText(n,s.width-a-c,l,c),r.fillText(t,a,l,s.width-c-3*a)}async finish(){let e=(performance.now()-this.begun)/1e3;this.pen.fillStyle=Me("paper");for(let t=performance.now()+GR;performance.now()<t;)await new Promise(n=>setTimeout(()=>requestAnimationFrame(n),HR)),this.pen.fillRect(0,0,1,1),this.track.requestFrame();return await this.stop(),{clip:new Blob(this.chunks,{type:"video/webm"}),took:e}}stop(){if(this.recorder.state==="inactive")return Promise.resolve();let e=new Promise(t=>this.recorder.addEventListener("stop",()=>{this.track.stop(),t()}));return this.recorder.stop(),e}},qR=5e-7;function cv(i,e,t){let n=XR(),s=null,r=0,o=M("select",{class:"w-select","aria-label":"Part of the run"}),a=M("button",{class:"w-button",type:"button",click:()=>f()}),l=M("button",{class:"w-button",type:"button",hidden:!0,click:()=>d("The recording was cancelled.")},"Cancel"),c=M("progress",{max:1,value:0,hidden:!0,"aria-label":"Progress of the recording"}),h=M("p",{role:"status"},n??"The clip shows the current view, with title, clock and result."),u=M("a",{class:"w-button",hidden:!0},"Save the clip");a.disabled=n!==null;let d=y=>{s?.stop(),s=null,i.onDrawn=null;for(let S of[l,c])S.hidden=!0;ze(h,y),t.playing&&t.pause(),m()},f=()=>{let y=e.rounds[Number(o.value)-1],[S,b]=y?[y.start,Math.min(y.end-(y===e.rounds.at(-1)?0:qR),t.end)]:[0,t.end];if(!(b>S))return d("Nothing to record: this part takes no time.");let A=Math.max(1,t.speed);t.pause(),t.setSpeed(A),t.seek(S);try{s=new fm(i,e,t,S,b,A)}catch(v){return d(`The recording cannot start: ${v.message}`)}for(let v of[l,c])v.hidden=!1;u.hidden=!0,ze(h,`Recording ${Je(b-S,0)} at ${A}\xD7.`);let R=s;r=S,i.onDrawn=()=>{i.onDrawn=()=>R.draw(),R.start(()=>{s===R&&t.play()})},i.ask(),m()},p=async y=>{y.isRunning=!1,t.pause(),t.seek(y.to);let{clip:S,took:b}=await y.finish();if(s!==y)return;let A=(y.to-y.from)/y.speed,R=Math.abs(b-A)<=$R*A+.2;URL.revokeObjectURL(u.href),Object.assign(u,{href:URL.createObjectURL(S),hidden:!1,download:`${(e.head?.title||"recording").replace(/[^\p{L}\p{N}]+/gu,"-")}.webm`}),d(`${Je(b)} at ${y.speed}\xD7, ${(S.size/1e6).toFixed(1)} MB.${R?"":` The clip is not of this speed: it should take ${Je(A)}. This machine draws too slowly.`}`)},x=t.subscribe(()=>{if(!s?.isRunning)return;let{from:y,to:S,speed:b}=s,A=t.time-r;r=t.time,c.value=(t.time-y)/(S-y),t.time>=S-1e-6?p(s):(!t.playing||t.speed!==b||A<0||A>WR*b)&&d("The recording was cancelled, because the clock was changed.")}),g=()=>{document.hidden&&s&&d("The recording was cancelled, because the page was hidden.")};document.addEventListener("visibilitychange",g);let m=()=>{let{rounds:y,live:S}=e;if(o.length!==y.length+1){let b=o.value;o.replaceChildren(M("option",{value:0},"Whole run"),...y.map(({number:A},R)=>M("option",{value:R+1},`Round ${A}`))),b&&(o.value=b)}a.disabled=n!==null||S||s!==null||!y.length,S&&!n&&ze(h,"A live run can be recorded once it has ended."),ze(a,`Record at ${Math.max(1,t.speed)}\xD7`)};return m(),{element:M("details",{class:"w-film",name:"w-menu"},M("summary",{},"Film"),M("div",{},o,a,l,c,u,h)),show:m,destroy:()=>{document.removeEventListener("visibilitychange",g),x(),s&&d(""),URL.revokeObjectURL(u.href)}}}var hv=[["Space","play, pause"],["\u2190 \u2192","0.1 s back, forward (with Shift: 1 s)"],["[ ]","previous, next event or stroke"],["Home End","start, end"],["+ \u2212","faster, slower"],["L","follow a live run"],["F","fit view"],["T","follow the work: wide in free motion, close at strokes"],["V","view from above"],["W A S D","turn the scene (while it has the focus)"],["Z X","zoom in, out (while the scene has the focus)"],["I O","start (I) or end (O) the selected part of the path at the shown time (or drag on the plot of forces)"],["Esc","end the selection; close a menu"]];function od(i,e,t){return(t>0?i.find(s=>s>e+.05):i.findLast(s=>s<e-.05))??(t>0?i.at(-1)??e:i[0]??e)}var rd=[],YR=(i,e)=>!(i instanceof HTMLElement)||e==="Escape"?!1:i.isContentEditable||/^(TEXTAREA|SELECT)$/.test(i.tagName)?!0:i instanceof HTMLInputElement&&i.type==="range"?/^(Arrow|Page|Home$|End$)/.test(e):i instanceof HTMLInputElement?!(i.type==="checkbox"&&e!==" "):e===" "&&/^(BUTTON|A|SUMMARY)$/.test(i.tagName);function uv(i,e,t,n){rd.push(i);let s=a=>{e.playing&&e.pause(),e.seek(e.time+a)},r={" ":()=>e.toggle(),ArrowLeft:a=>s(a?-1:-.1),ArrowRight:a=>s(a?1:.1),"[":()=>e.seek(od(t.stops,e.time,-1)),"]":()=>e.seek(od(t.stops,e.time,1)),Home:()=>e.seek(0),End:()=>e.seek(e.end),"+":()=>e.faster(1),"=":()=>e.faster(1),"-":()=>e.faster(-1)},o=a=>{if(a.ctrlKey||a.metaKey||a.altKey||a.defaultPrevented||YR(a.target,a.key))return;let l=a.target,c=l===document.body||l===document.documentElement;if(!i.contains(l)&&!(c&&rd[0]===i))return;let h=r[a.key];if(h)h(a.shiftKey);else if(!n(a.key.toLowerCase()))return;a.preventDefault()};return document.addEventListener("keydown",o),()=>{document.removeEventListener("keydown",o),rd.splice(rd.indexOf(i),1)}}var dv={believed:["Believed and predicted dirt",({rounds:i})=>i.some(e=>bn(e)?e.treated!==null:e.plan.particles.length>0)],estimated:["Estimated dirt after the round",({rounds:i})=>i.some(e=>(bn(e)?e.interpreted?.treated:e.interpreted)!=null)],actual:["True dirt after the round",({rounds:i})=>i.some(e=>(bn(e)?e.truth?.treated:e.truth?.particles)!=null)],seen:["Observed dirt",({rounds:i,before:e})=>e.observed??i.some(({observed:t})=>t)],path:["Tool path",({rounds:i})=>i.some(({count:e})=>e)],ribbon:["Force along the path",({rounds:i})=>i.some(({count:e})=>e)],strokes:["Planned strokes",({rounds:i})=>i.some(({plan:e})=>e.strokes.length)],rejected:["Rejected plan, chosen in its table",({rounds:i})=>i.some(({plan:e})=>e.another||e.considered?.some(({lines:t})=>t?.length))],bases:["Rated base poses",({rounds:i})=>i.some(({plan:e})=>e.bases?.poses.length)],force:["Force",({rounds:i})=>i.some(({count:e})=>e)],events:["Events, force at pushes or collisions",({happenings:i})=>i.length],found:["Surface found by touch",({rounds:i})=>i.some(({interpreted:e})=>e?.found)],actualSurface:["True surface",({rounds:i})=>i.some(({truth:e})=>e?.surface)],collision:["Collision shapes",({head:i})=>i?.robot?.links.some(e=>Kp(e).length)]},ad=24,ld=class{constructor(e,t,n){this.recording=e;let s=M("canvas",{class:"w-canvas",tabindex:0,role:"application","aria-label":"Robot, tool and surface in 3-D. W A S D turn the scene, Z and X zoom."});this.stage=ZR(s,e,()=>this.follow.setAttribute("aria-pressed","false"));let r=(f,p,x)=>M("button",{class:"w-button",type:"button",title:p,click:x},f);this.follow=r("Follow","Follow the work: wide in free motion, close at strokes  T",()=>this.toggleFollow()),this.follow.setAttribute("aria-pressed","false");let o=M("input",{type:"range",min:0,max:.95,step:.05,value:0,"aria-label":"Transparency of the robot",input:()=>{this.stage&&(this.stage.xray=Number(o.value))}}),a=M("div",{class:"w-views",role:"group","aria-label":"View"},r("Fit","Show all of robot and surface  F",()=>this.look("all")),r("Surface","Close view of the surface",()=>this.look("surface")),r("Above","View from above  V",()=>this.look("above")),this.follow,M("label",{class:"w-button w-xray",title:"Look through the robot"},"X-ray",o));if(this.element=M("section",{class:"w-scene","aria-label":"Scene"},this.stage?s:M("p",{class:"w-none"},"This browser cannot draw 3-D graphics. The other panels still work."),this.stage&&a,this.stage&&this.legend(t),M("div",{class:"w-scene-scale"},this.forceScale,this.reach,this.mapScale),this.extra,this.point,this.still),!this.stage)return;let{stage:l}=this,c=!1,h=()=>{let{clientWidth:f,clientHeight:p}=s,x=this.element.querySelector(".w-layers");!c&&f&&f<=640&&x&&(x.open=!1),c||=f>0,l.resize(f,p,x?.open&&f>640?x.offsetWidth:0)},u=new ResizeObserver(h);u.observe(s),this.element.addEventListener("toggle",h,!0);let d={x:0,y:0};s.addEventListener("pointerdown",({offsetX:f,offsetY:p})=>{d={x:f,y:p}}),s.addEventListener("click",({offsetX:f,offsetY:p})=>{if(Math.hypot(f-d.x,p-d.y)>3)return;let x=l.timeAt(f,p);x!==null&&n(x)}),s.addEventListener("pointermove",({offsetX:f,offsetY:p,buttons:x})=>this.explain(x?null:[f,p])),s.addEventListener("pointerleave",()=>this.explain(null)),this.stop.push(()=>u.disconnect(),io(()=>{l.paint(),this.listNamed(),so()&&(this.still.src=l.picture())}))}recording;element;stage;boxes=new Map;extra=M("ul",{class:"w-named"});follow;still=M("img",{class:"w-still",alt:"The robot and the surface at the shown time"});stop=[];mapTitle=M("strong");mapScale=M("div",{class:"w-map-scale",hidden:!0},this.mapTitle);forceTitle=M("strong");forceScale=M("div",{class:"w-force-scale",hidden:!0},this.forceTitle,ar(ro));point=M("div",{class:"w-point",hidden:!0});reach=Py();shown=sr;choice=null;scaleOf=null;treats=!1;version=-1;time=0;show(e){if(this.stage?.show(e),this.time=e,this.showScale(),this.version===this.recording.version)return;this.version=this.recording.version;let{rounds:t,head:n}=this.recording,s=n?.robot;s&&jp(s)&&this.boxes.get("collision")?.querySelector("label").replaceChildren(wo("collision"),"Collision shapes (the robot's shell is drawn from them)");let r=t.find(bn);this.stage&&r&&!this.treats&&this.nameMaps(r),this.element.toggleAttribute("data-target",t.some(({target:a})=>a!==null));for(let[a,l]of this.boxes)l.hidden=!dv[a][1](this.recording);let o=this.element.querySelector(".w-layers");o&&(o.hidden=[...this.boxes.values()].every(({hidden:a})=>a))}explain(e){let t=e&&this.stage.timeAt(...e),n=t===null?null:this.recording.at(t);if(this.point.hidden=n?.normal==null,!e||n?.normal==null)return;let{normal:s,height:r,round:o}=n,a=o.isPressed(n.time)?o.target:null;ze(this.point,[`${Be(s,1)} N${a===null?"":`, ${_e(s/a)} of the target of ${Be(a,1)} N`}`,r===null?"":`tool height ${pl(n)}`,`${Je(t,2)} (click to go there)`].filter(f=>f).join(`
`));let[l,c]=e,{offsetWidth:h,offsetHeight:u}=this.point,d=l+h+ad>this.element.clientWidth;Object.assign(this.point.style,{left:`${d?l-h-ad:l+ad}px`,top:`${Math.max(2,c-u-ad)}px`})}showScale(){let e=this.stage&&this.recording.roundAt(this.time);this.forceScale.hidden=!e?.target||!e.count||!this.stage.layers.ribbon,e?.target&&ze(this.forceTitle,`Force along the path, target ${Be(e.target,1)}\u202FN`);let t=e&&Ru(this.recording,this.time,e,this.stage.layers);this.reach.hidden=!e?.plan.bases||!this.stage.layers.bases,this.mapScale.hidden=!t,t&&(ze(this.mapTitle,t.title),this.scaleOf!==t.record&&(this.scaleOf=t.record,this.mapScale.replaceChildren(this.mapTitle,dl(t.record))))}nameMaps(e){this.treats=!0;let t=_i(e),n={believed:`Predicted ${t}`,estimated:`Estimated ${t} after the round`,actual:`True ${t} after the round`};for(let[s,r]of Object.entries(n))this.boxes.get(s)?.querySelector("label").replaceChildren(wo("map"),r);for(let s of["actual","ribbon"])this.stage.layers[s]=!1,this.boxes.get(s).querySelector("input").checked=!1}look(e){this.follow.setAttribute("aria-pressed","false"),this.stage?.look(e)}toggleFollow(){this.stage&&(this.stage.follow=!this.stage.follow,this.follow.setAttribute("aria-pressed",String(this.stage.follow)))}showData(e){this.shown=e,this.stage?.showData(e),this.listNamed()}get queried(){let{trajectories:e,ghosts:t,frames:n,particles:s}=this.shown;return[...e.map(({name:r,color:o},a)=>({name:r,colour:xu(o,a)})),...t.map(({time:r,color:o})=>({name:`${this.recording.head?.robot?"robot":"tool"} at ${Je(r)}`,colour:Gi(o,Me("ghost"))})),...n.map(({name:r,color:o})=>({name:r,colour:Gi(o,Me("axis-z"))})),...s.map(({name:r,color:o,state:a})=>({name:r,colour:Sp(o),form:a}))]}choose(e){this.choice=e,this.stage?.choose(e),this.listNamed()}listNamed(){let{stroke:e=null,rejected:t=null}=this.choice??{},n=[...e===null?[]:[{name:`Stroke ${e+1}`,colour:"var(--chosen)"}],...t&&this.stage?.layers.rejected?[{name:t.name,colour:"var(--rejected)"}]:[]];this.extra.replaceChildren(...[...n,...this.queried].map(({name:s,colour:r,form:o})=>{if(o)return M("li",{},iv(r,o==="estimated"),s);let a=M("i",{"aria-hidden":"true"});return a.style.background=r,M("li",{},a,s)}))}destroy(){for(let e of this.stop)e();this.stage?.destroy()}legend(e){let t=Object.keys(Ku).map(n=>{let s=ai(),r=M("input",{type:"checkbox",id:s,checked:Ku[n],change:()=>{this.stage&&(this.stage.layers[n]=r.checked,this.stage.ask(),this.showScale(),this.listNamed())}}),o=M("li",{},r,M("label",{for:s},wo(n),dv[n][0]));return this.boxes.set(n,o),o});return M("details",{class:"w-layers",open:!e},M("summary",{},"Layers"),M("ul",{},...t))}};function ZR(i,e,t){try{return new ju(i,e,t)}catch{return null}}var jR=170,pm=15,fv=8,mm=3,KR=3;function JR(i,e,t){let n=({label:l,count:c})=>Math.min(jR,e(pv(l,c))),s=[],r=new Map;for(let{x:l,label:c}of[...i].sort((h,u)=>h.x-u.x)){let h=r.get(c);if(h&&l<h.x+n(h)+fv){h.count++;continue}let u={x:l,label:c,count:1};s.push(u),r.set(c,u)}let o=Array.from({length:KR},()=>-1/0),a=[];for(let l of s){let c=n(l),h=Math.min(l.x,t-c),u=o.findIndex(d=>d+fv<=h);u<0||(o[u]=h+c,a.push({text:pv(l.label,l.count),x:h,width:c,row:u}))}return a}var pv=(i,e)=>e>1?`${i} \xD7${e}`:i;function mv(i,e,t){let n=e.lane("rounds")?.top??0,s=e.width-e.right,r=[];i.fillStyle=Me("highlight");for(let{start:o,end:a,label:l}of t){if(a<e.from||o>e.to)continue;let c=Math.max(e.left,e.x(o)),h=Math.max(c+2,Math.min(s,e.x(a)));i.globalAlpha=.28,i.fillRect(c,n,h-c,e.height-n),i.globalAlpha=1,i.fillRect(c,n-3,h-c,3),l&&r.push({x:c+mm,label:l})}qn(i,10,{weight:600});for(let{text:o,x:a,width:l,row:c}of JR(r,h=>i.measureText(h).width,s)){let h=e.height-4-(c+.5)*pm;i.globalAlpha=.85,i.fillStyle=Me("paper"),i.beginPath(),i.roundRect(a-mm,h-pm/2+1,l+2*mm,pm-2,3),i.fill(),i.globalAlpha=1,i.fillStyle=Me("ink"),ys(i,o,a,h+.5,l+1)}}function gv(i,e,{top:t,height:n},[s,r],o){if(r<e.from||s>e.to)return;let a=e.width-e.right,[l,c]=[s,r].map(h=>Math.min(a,Math.max(e.left,e.x(h))));i.fillStyle=Me("paper"),i.globalAlpha=.65,i.fillRect(e.left,t-2,l-e.left,n+4),i.fillRect(c,t-2,a-c,n+4),i.globalAlpha=1,i.strokeStyle=Me("accent"),i.lineWidth=1.5,i.strokeRect(l,t-1,c-l,n+2),qn(i,10),i.fillStyle=Me("ink"),ys(i,o,l+5,t+7,c-l-10)}function xv(i,e,t,n,s,r,o){let a=l=>t.top+t.height-(l-n)/(s-n)*t.height;qn(i,10,{align:"right"});for(let l of Ux(n,s,r))en(i,e.left,a(l),e.width-e.right,a(l),Math.abs(l)<1e-12?"rule":"grid"),i.fillStyle=Me("quiet"),i.fillText(o(l),e.left-5,Math.min(Math.max(a(l),t.top+4),t.top+t.height-3));return a}var yv=(i,{top:e,height:t})=>[i.left-1,e-2,i.span+2,t+4];function gm(i,e,t,n,s,r){let[o,a]=[0,r.least];for(let u of n.rounds){let{least:d,largest:f}=s(u);d<=f&&([o,a]=[Math.min(o,d*r.unit),Math.max(a,f*r.unit,r.target?.(u)??0)])}r.bounds&&([o,a]=[Math.max(o,r.bounds[0]),Math.min(a,r.bounds[1])]);let l=.06*(a-o),c=xv(i,e,t,o<0?o-l:0,a+l,3,u=>String(Number(u.toPrecision(3))).replace("-","\u2212")),h=null;sl(i,yv(e,t),()=>{for(let u of n.rounds){if(u.end<e.from||u.start>e.to||!u.count)continue;let d=r.target?.(u)??null;d!==null&&_v(i,[Math.max(e.left,e.x(u.start)),e.x(u.end)],c(d),e.narrow||d===h?"":`target ${Be(d,1)}\u202FN`,!0),h=d,i.strokeStyle=Me(r.name),i.lineWidth=1.5,i.lineJoin="round";let f=u.count*((e.to-e.from)/Math.max(u.length,1e-9))>4*e.span;vv(i,(f?eC:QR)(e,u,s(u),p=>c(p*r.unit)))}})}function vv(i,e){i.beginPath(),e.forEach((t,n)=>{t&&(e[n-1]?i.lineTo(...t):i.moveTo(...t))}),i.stroke()}function QR(i,e,{data:t},n){let s=e.place(i.from-e.start)[0],r=Math.min(e.count,e.place(i.to-e.start)[0]+2);return t.slice(s,r).map((o,a)=>Number.isFinite(o)?[i.x(e.start+e.t[s+a]),n(o)]:null)}function eC(i,e,t,n){let s=[];return Sy(i,e,(r,o,a)=>{let l=t.range(o,a+1);if(!l)return void s.push(null);let[c,h]=[n(l[1]),n(l[0])];s.push([r,h],[r,h-c<.7?h-.7:c])}),s}var tC=14;function bv(i,e,t,n){let s=xv(i,e,t,0,1,2,a=>Be(100*a,0)),r=n.head?.task?.target,o=e.width-e.right;sl(i,yv(e,t),()=>{r!==void 0&&_v(i,[e.left,o],s(r),`target ${_e(r)}`,r<=.8);for(let a of n.rounds)a.end<e.from||a.start>e.to||nC(i,e,a,s)}),n.rounds.forEach((a,l)=>{if(!a.interpreted||a.end>e.to+1e-9)return;let c=iC(e,a,n.rounds[l+1]);c&&sC(i,c,a.interpreted.estimate,s),a.end>=e.from&&rC(i,e,a,s)})}function _v(i,[e,t],n,s,r){i.setLineDash([6,4]),en(i,e,n,t,n,"target",1.5),i.setLineDash([]),qn(i,10,{base:r?"bottom":"top"}),i.fillStyle=Me("target"),i.fillText(s,e+5,n+(r?-2:3))}function nC(i,e,t,n){let s=t.plan.growth;s.length&&(i.strokeStyle=Me("believed"),i.lineWidth=2.2,i.lineCap="round",i.setLineDash(Ox),vv(i,[...s,[1/0,s.at(-1)[1]]].map(([r,o])=>[e.x(t.start+Math.min(r,t.length)),n(o)])),i.setLineDash([]),i.lineCap="butt")}function iC(i,e,t){let n=i.x(e.end),s=t?i.x(t.start+t.firstContact):0,[r,o]=[Math.max(n,i.left),Math.min(Math.max(n+tC,s),i.width-4)];return o>r?[r,o]:null}function sC(i,[e,t],{mean:n,low:s,high:r},o){i.fillStyle=Me("interval"),i.fillRect(e,o(r),t-e,Math.max(1,o(s)-o(r)));for(let a of[s,r])en(i,e,o(a),t,o(a),"estimated",1);en(i,e,o(n),t,o(n),"estimated",2.4)}function rC(i,e,t,n){let{estimate:s,by_touch:r}=t.interpreted,o=e.x(t.end),a=t.growthAt(t.length);a!==null&&oC(i,o,n(a),n(s.mean)),(r.low!==s.low||r.high!==s.high)&&aC(i,o-13,n,r,"by-touch",1.4,3);let l=t.truth?.performance??null;if(l===null)return;let c=n(l);for(let[h,u]of[[5,"paper"],[2.4,"actual"]])en(i,o+3,c-4.5,o+12,c+4.5,u,h),en(i,o+12,c-4.5,o+3,c+4.5,u,h)}function oC(i,e,t,n){if(en(i,e,t,e,n,"ink",1.4),Math.abs(n-t)<8)return;let s=6*Math.sign(t-n);en(i,e-3.5,n+s,e,n,"ink",1.4),en(i,e+3.5,n+s,e,n,"ink",1.4)}function aC(i,e,t,{mean:n,low:s,high:r},o,a,l){en(i,e,t(s),e,t(r),o,a),en(i,e-l,t(s),e+l,t(s),o,a),en(i,e-l,t(r),e+l,t(r),o,a),i.fillStyle=Me(o),i.beginPath(),i.arc(e,t(n),1.7*a,0,2*Math.PI),i.fill()}function wv(i,e){let t=new Map,n=!1,s=null,r=l=>{let{left:c,width:h}=i.getBoundingClientRect();return(l.clientX-c)*(i.clientWidth/h||1)},o=()=>{let[l=0,c=0]=[...t.values()];return{middle:(l+c)/2,distance:Math.max(10,Math.abs(l-c))}};i.addEventListener("pointerdown",l=>{if(!(l.button!==0||l.target instanceof HTMLButtonElement))if(t.set(l.pointerId,r(l)),i.setPointerCapture(l.pointerId),i.focus({preventScroll:!0}),t.size===1){n=!1;let{top:c,height:h}=i.getBoundingClientRect();s=l.pointerType!=="touch"&&e.selectsAt((l.clientY-c)*(i.clientHeight/h||1))?r(l):null,e.select(null),e.seek(r(l))}else n=!0}),i.addEventListener("pointermove",l=>{if(!t.has(l.pointerId)){e.hover(r(l));return}let c=o();if(t.set(l.pointerId,r(l)),t.size===2){let h=o();e.zoom(c.middle,c.distance/h.distance,h.middle-c.middle)}else n||(s===null?e.seek(r(l)):Math.abs(r(l)-s)>4&&e.select([s,r(l)]),e.hover(r(l)))});let a=l=>{t.delete(l.pointerId),l.pointerType!=="mouse"&&e.hover(null)};i.addEventListener("pointerup",a),i.addEventListener("pointercancel",a),i.addEventListener("pointerleave",()=>e.hover(null)),i.addEventListener("dblclick",()=>e.reset()),i.addEventListener("wheel",l=>{let{scrollHeight:c,clientHeight:h}=document.documentElement,u=Math.abs(l.deltaX)>Math.abs(l.deltaY)||l.shiftKey;if(!(l.ctrlKey||u||i.contains(document.activeElement)||c<=h+1))return;l.preventDefault();let f=l.shiftKey&&!l.deltaX?l.deltaY:u?l.deltaX:l.deltaY;u?e.zoom(r(l),1,-f):e.zoom(r(l),Math.exp(Math.max(-1,Math.min(1,f*.002))),0)},{passive:!1})}var lC=["axis","rounds","phases","contact","events","force","height","performance"],cC=["axis","rounds","phases","contact","events","force"],hC=[-20,80],uC=700,Mv=700,Sv={card:60,software:250},Tv=.2,cd=class{constructor(e,t,n,s){this.recording=e;this.clock=t;this.selected=s;this.frame=new hu(n?cC:lC),this.element=M("div",{class:"w-timeline",role:"slider",tabindex:0,"aria-label":"Time in the run","aria-valuemin":0,"aria-describedby":this.description.id,"aria-keyshortcuts":"Space ArrowLeft ArrowRight [ ] Home End I O Escape"},this.base,this.veil,this.hair,this.cursor,this.whole,this.tip,this.description),wv(this.element,{seek:a=>{t.playing&&t.pause(),t.seek(this.timeAt(a))},selectsAt:a=>{let l=this.frame.lane("force");return l!==void 0&&a>=l.top&&a<=l.top+l.height},select:a=>this.select(a&&[this.timeAt(Math.min(...a)),this.timeAt(Math.max(...a))]),hover:a=>this.hover(a),zoom:(a,l,c)=>this.zoom(a,l,c),reset:()=>this.reset()});let r=new ResizeObserver(()=>this.resize());r.observe(this.element),requestAnimationFrame(()=>{let a=this.element.closest(".w-view");a&&r.observe(a)});let o=co(ir()?Sv.software:Sv.card,()=>this.redraw());this.stop.push(()=>r.disconnect(),o.stop,t.subscribe(()=>this.ask()),e.onChange(()=>e.live?o.ask():this.redraw()),io(()=>this.resize()))}recording;clock;selected;element;base=M("canvas",{"aria-hidden":"true"});cursor=M("i",{class:"w-cursor","aria-hidden":"true"});hair=M("i",{class:"w-hair","aria-hidden":"true",hidden:!0});veil=M("i",{class:"w-veil","aria-hidden":"true",hidden:!0});whole=M("button",{class:"w-button w-whole",type:"button",hidden:!0,title:"Show the whole run  (double-click)",click:()=>this.reset()},"Whole run");tip=M("div",{class:"w-tip",hidden:!0});description=M("p",{class:"w-hidden",id:ai()});frame;stop=[];highlights=[];selection=null;zoomed=!1;moved=()=>this.draw();stale=!0;drawnDuration=-1;hovered=null;highlight(e){this.highlights=e,this.redraw()}timeAt(e){return this.frame.t(Math.min(Math.max(e,this.frame.left),this.frame.width-this.frame.right))}select(e){return!e&&!this.selection?!1:(this.selection=e,this.selected(e),this.redraw(),!0)}selectTo(e){let{time:t,duration:n}=this.clock,[s,r]=this.selection??[0,n],o=e?[s<t?s:0,t]:[t,r>t?r:n];o[0]<o[1]&&this.select(o)}redraw(){this.stale=!0,this.ask()}destroy(){An.drop(this.moved);for(let e of this.stop)e()}ask(){An.draw(this.moved)}resize(){let e=so()?uC:this.element.clientWidth;if(!e)return;this.frame.layOut(e,so()||(this.element.closest(".w-view")?.clientHeight??Mv)<Mv);let t=this.element.currentCSSZoom??1,n=so()?3:Math.min((devicePixelRatio||1)*t,2);this.base.width=Math.round(e*n),this.base.height=Math.round(this.frame.height*n),this.base.style.width=`${e}px`,this.base.style.height=`${this.frame.height}px`,this.element.style.height=`${this.frame.height}px`,this.stale=!0,An.drop(this.moved),this.draw()}reset(){this.zoomed=!1,this.redraw()}zoom(e,t,n){let{frame:s}=this,r=Math.max(this.clock.duration,Tv),o=s.t(e),a=Math.min(r,Math.max(Tv,(s.to-s.from)*t)),l=(o-s.from)/(s.to-s.from),c=o-l*a-n/s.span*a;c=Math.min(Math.max(0,c),r-a),[s.from,s.to]=[c,c+a],this.zoomed=a<r*.999,this.redraw()}pen(){let e=this.base.getContext("2d",{willReadFrequently:ir()}),t=this.base.width/(parseFloat(this.base.style.width)||1);return e.setTransform(t,0,0,t,0,0),e.clearRect(0,0,this.frame.width,this.frame.height),e}draw(){let{recording:e,clock:t,frame:n}=this,{duration:s}=t;this.zoomed?(t.playing||t.following)&&this.scrollToCursor():[n.from,n.to]=[0,Math.max(s,.001)],(this.stale||this.drawnDuration!==s)&&(this.drawBase(),ze(this.description,e.rounds.map(l=>dC(e,l)).join(" ")),this.drawnDuration=s,this.stale=!1),this.whole.hidden=!this.zoomed,this.moveOverlays();let{element:r}=this;r.setAttribute("aria-valuemax",s.toFixed(1)),r.setAttribute("aria-valuenow",t.time.toFixed(2));let o=e.at(t.time),a=o?.round.plan.phases[o.phase]?.name;r.setAttribute("aria-valuetext",`${Je(t.time)}${o?`, round ${o.round.number}`:""}${a?`, ${Rs(a)}`:""}${this.selection?`, ${xm(e,this.selection)}`:""}`)}scrollToCursor(){let{frame:e,clock:t}=this,n=e.to-e.from;if(t.time>=e.from&&t.time<=e.to-.03*n)return;let s=Math.min(Math.max(0,t.time-.1*n),Math.max(0,t.duration-n));Math.abs(s-e.from)<1e-9||([e.from,e.to]=[s,s+n],this.stale=!0)}drawBase(){let{frame:e,recording:t}=this,n=this.pen();for(let r of e.lanes){switch(r.name){case"axis":by(n,e,r);break;case"rounds":_y(n,e,r,t);break;case"phases":wy(n,e,r,t);break;case"contact":My(n,e,r,t);break;case"events":Ty(n,e,r,t);break;case"force":gm(n,e,r,t,a=>a.normal,{name:"force",unit:1,least:5,target:a=>a.target});break;case"height":gm(n,e,r,t,a=>a.height,{name:"height",unit:1e3,least:10,bounds:hC});break;case"performance":bv(n,e,r,t);break}qn(n),n.fillStyle=Me("quiet");let o=fp.has(r.name);e.narrow?o&&n.fillText(r.label,2,r.top-8):r.label.split(`
`).forEach((a,l)=>ys(n,a,2,r.top+(o?8+13*l:r.height/2),e.left-(o?26:6)))}mv(n,e,this.highlights);let s=e.lane("force");s&&this.selection&&gv(n,e,s,this.selection,xm(this.recording,this.selection)),this.drawVeil()}moveOverlays(){let{frame:e,clock:t}=this,n=e.width-e.right,s=e.x(t.time);this.cursor.hidden=s<e.left-1||s>n+1,this.cursor.style.transform=`translateX(${s.toFixed(1)}px)`,this.hair.hidden=this.hovered===null,this.hovered!==null&&(this.hair.style.transform=`translateX(${this.hovered}px)`)}drawVeil(){let{frame:e,recording:t}=this,n=e.width-e.right,s=Math.min(n,Math.max(e.left,e.x(t.now)));this.veil.hidden=!t.live||s>=n,Object.assign(this.veil.style,{left:`${s}px`,width:`${n-s}px`})}hover(e){let{frame:t}=this,n=e!==null&&e>=t.left&&e<=t.width-t.right;this.hovered=n?e:null,this.tip.hidden=!n,n&&(ze(this.tip,this.describe(t.t(e)).join(`
`)),this.tip.style.left=`${Math.max(2,Math.min(e-this.tip.offsetWidth/2,t.width-this.tip.offsetWidth-2))}px`),this.ask()}describe(e){let t=this.recording.at(e);if(!t)return[Je(e,2)];let{round:n,normal:s,height:r,performance:o,phase:a,contact:l}=t,c=4*((this.frame.to-this.frame.from)/this.frame.span),h=this.recording.happenings.filter(({start:f,end:p})=>e>=f-c&&e<=p+c),u=this.highlights.filter(({start:f,end:p,label:x})=>x&&e>=f-c&&e<=p+c).map(({label:f})=>f),d=this.recording.rounds.findLast(f=>f.interpreted&&Math.abs(e-f.end)<4*c)??this.recording.resultAt(e);return[`${Je(e,2)} \xB7 round ${n.number}`,Rs(n.plan.phases[a]?.name??""),s===null?"":`force ${Be(s,1)} N${l==="none"||n.target===null?"":`, target ${Be(n.target,1)} N`}`,r===null?"":`tool height ${pl(t)}`,l==="none"?"":l==="pushed"?`pushed by somebody or something${r!==null&&r>tp?", not on the surface":""}`:"contact with the surface",o===null?"":`performance ${_e(o)} predicted`,...d?fC(d):[],this.selection&&e>=this.selection[0]&&e<=this.selection[1]?xm(this.recording,this.selection):"",...new Set(u),...h.map(({kind:f,words:p})=>`${f}: ${p}`)].filter(f=>f!=="")}};function dC(i,e){let{number:t,start:n,end:s,plan:r,contacts:{contact:o,pushed:a},normal:l,interpreted:c,events:h}=e,u=x=>Je(x.reduce((g,[m,y])=>g+y-m,0)),d=r.kind==="logged",f=e.count>0&&l.least<=l.largest,p=(x,g)=>`${x} ${g}${x===1?"":"s"}`;return`${[`Round ${t}, ${Je(n)} to ${Je(s)}`,d?"":p(r.strokes.length,"stroke"),f?`in contact for ${u(o)}`:d?"":`planned contact for ${u(o)}`,a.length?`pushed for ${u(a)}`:"",h.length?p(h.length,"detected event"):"",l.largest>0?`force at most ${Be(l.largest,1)} N`:"",r.predicted===null?"":`predicted ${_e(r.predicted)}`,c?`estimated ${Gt(c.estimate)}`:"",mo(i,e)].filter(x=>x).join(", ")}.`}function fC(i){let{estimate:e}=i.interpreted,t=i.growthAt(i.length);return[`performance after round ${i.number}: ${Gt(e)} estimated`,t===null?"":`the estimate after round ${i.number} replaces the prediction of ${_e(t)}`,typeof i.truth?.performance=="number"?`true performance after round ${i.number}: ${_e(i.truth.performance)}`:""]}function xm({rounds:i},[e,t]){let n=i.filter(o=>o.count&&o.start<=t&&o.end>=e).map(o=>o.normal.range(o.place(e-o.start)[0],o.place(t-o.start)[0]+1)).filter(o=>o!==null),[s,r]=[Math.min(...n.map(o=>o[0])),Math.max(...n.map(o=>o[1]))];return`selected: ${Je(e,2)} to ${Je(t,2)}${n.length?`, force ${Be(s,1)} to ${Be(r,1)} N`:""}`}function Ev(i,e,t){let n=M("button",{class:"w-button w-play",type:"button",click:()=>i.toggle()}),s=u=>M("button",{class:"w-button w-icon",type:"button","aria-label":u<0?"Previous event or stroke":"Next event or stroke",title:u<0?"Previous event or stroke  [":"Next event or stroke  ]",click:()=>i.seek(od(e.stops,i.time,u))},hm(u<0?"before":"after")),r=M("button",{class:"w-button w-live",type:"button",title:"Follow the live run  L",click:()=>i.follow()},"LIVE"),o=M("output",{class:"w-time","aria-live":"off"}),a=M("select",{class:"w-select","aria-label":"Playback speed",change:()=>i.setSpeed(Number(a.value))},...bo.map(u=>M("option",{value:u},`${u}\xD7`))),l=M("details",{class:"w-keys",name:"w-menu"},M("summary",{},"Keys"),M("dl",{},...hv.flatMap(([u,d])=>[M("dt",{},u),M("dd",{},d)]))),c=null,h=()=>{let u=i.playing||i.following;u!==c&&(c=u,n.replaceChildren(hm(u?"pause":"play"),M("span",{},u?"Pause":"Play")),n.setAttribute("aria-label",u?"Pause":"Play")),r.hidden=!i.live,r.setAttribute("aria-pressed",String(i.following)),ze(o,`${Je(i.time)} / ${Je(i.duration)}${i.isLate?" (slower than real time)":""}`),Number(a.value)!==i.speed&&(a.value=String(i.speed))};return h(),{element:M("div",{class:"w-transport",role:"group","aria-label":"Playback"},n,s(-1),s(1),r,o,a,t,l),show:h}}var pC=150;function mC(i,e,t,n,s){return uv(i,e,t,r=>{if(r==="f")n.look("all");else if(r==="v")n.look("above");else if(r==="t")n.toggleFollow();else if(r==="l"&&e.live)e.follow();else if(r==="i"||r==="o")s.selectTo(r==="o");else if(r!=="escape"||!(gC(i)||s.select(null)))return!1;return!0})}function gC(i){let e=i.querySelector("details[name=w-menu][open]");return e?(e.open=!1,e.querySelector("summary").focus(),!0):!1}function Ml(i,e,{compact:t=!1,clock:n}={}){let s=n??new _o,r=s.join(e),o=new ld(e,t,m=>{s.playing&&s.pause(),s.seek(m)}),a=new cd(e,s,t,m=>o.stage?.select(m)),l=t?null:new Fu(e,s,m=>o.choose(m)),c=o.stage&&!t?cv(o.stage,e,s):null,h=Ev(s,e,c?.element??null),u=M("div",{class:`w-view${t?" w-compact":""}`},M("div",{class:"w-grid"},o.element,l?.element,M("div",{class:"w-below"},h.element,a.element)));i.append(u);let d=co(ir()?pC:0,()=>{l?.show(),h.show(),c?.show()}),f=()=>{o.show(s.time),d.ask()},p=()=>An.draw(f),x=[r,s.subscribe(p),e.onChange(()=>{s.onGrowth(),p()}),mC(u,s,e,o,a)];return e.live&&s.follow(),f(),{element:u,clock:s,show:(m={})=>{let y={...sr,...m};a.highlight(y.intervals),o.showData(y)},seek:m=>s.seek(m),stage:o.stage,destroy:()=>{An.drop(f),d.stop(),c?.destroy();for(let m of x)m();o.destroy(),a.destroy(),n||s.destroy(),u.remove()}}}function So(i){let e=new URLSearchParams(i.replace(/^#/,"")),t=Number.parseFloat(e.get("t")??""),n={time:Number.isFinite(t)&&t>=0?t:null,query:e.get("q")||null};for(let r of["episode","run"]){let o=e.get(r);if(o)return{kind:r,ids:[o],...n}}let s=(e.get("compare")??"").split(",").filter(r=>r);return s.length===2?{kind:"compare",ids:s,...n}:{kind:"home",ids:[],...n}}function Ss({kind:i,ids:e,time:t,query:n}){let s=[];return i!=="home"&&s.push(`${i}=${e.map(encodeURIComponent).join(",")}`),t!==null&&i!=="home"&&s.push(`t=${t.toFixed(1)}`),n&&s.push(`q=${encodeURIComponent(n)}`),s.length?`#${s.join("&")}`:""}var Av=(i,e)=>i.kind===e.kind&&i.ids.join()===e.ids.join();function Rv(i){let e=Ss(i);e!==location.hash&&history.replaceState(null,"",e||location.pathname)}var To=["A","B"],xC=500,[rr,ym,Cv]=[52,14,18],hd={force:96,performance:110},yC=30,Sl=(i,e,t=1)=>n=>{let s=Be(t*n,e);return`${n>0?"+":""}${s}${i&&`\u202F${i}`}`},ud=Sl("points",0,100);function vC({rounds:i}){if(!i.some(({count:t})=>t))return null;let e=0;for(let t of i){let{tool:n}=t;for(let s=1;s<t.count;s++){let r=Math.hypot(...[0,1,2].map(o=>n[7*s+o]-n[7*s-7+o]));Number.isFinite(r)&&t.contactAt(t.t[s])==="contact"&&(e+=r)}}return e}function Pv(i){let{head:e,rounds:t,ended:n}=i,{state:s,text:r}=po(i),o=e?.task,a=t.flatMap(({plan:g})=>g.considered?.find(m=>m.chosen)?.strategy??[]),l=t.findLast(({interpreted:g})=>g)??t.at(-1),c=l?.interpreted,h=s==="unknown",u=l?.plan.predicted??null,d=l?.truth?.performance??null,f=Math.max(...t.map(({normal:g})=>g.largest)),p=vC(i),x=c?Gt(c.estimate,0,h?n.verdict:void 0):wn;return[{label:"Task",text:o?`${o.action} on ${o.surface}`:wn},{label:"Medium",text:o?.medium??wn},{label:"Tool",text:o?.tool??wn},{label:"Strategy",text:o?[o.strategy,...a.length?[`chosen: ${a.join(", ")}`]:[]].join("; "):wn},{label:"Target",text:rn(o?.target,_e),value:o?.target??null,by:ud},{label:"Rounds",text:String(t.length),value:t.length,by:Sl("",0)},{label:"Predicted, last round",text:rn(u,_e),value:u,by:ud},{label:"Estimated, last round",text:x,value:h?null:c?.estimate.mean??null,by:ud},{label:"True, last round",text:rn(d,_e),value:d,by:ud},{label:"Way in contact",text:rn(p,g=>`${Be(g,2)} m`),value:p,by:Sl("m",2)},{label:"Duration",text:Je(i.duration),value:i.duration,by:Sl("s",1)},{label:"Largest force",text:f>0?`${Be(f,1)} N`:wn,value:f>0?f:null,by:Sl("N",1)},{label:"Events",text:Cl(i.happenings.flatMap(({source:g,kind:m})=>g==="event"?[m]:[]))||"none"},{label:"Result",text:r}]}function bC(i,e){let t=Pv(e);return Pv(i).map(({label:n,text:s,value:r,by:o},a)=>{let l=t[a],c=typeof r=="number"&&typeof l.value=="number",h=(o?c:s!==wn)?"":wn;return{label:n,texts:[s,l.text],by:s===l.text?h:c?o(l.value-r):"differs"}})}function _C(i,e,t,n){return Array.from({length:n},(s,r)=>{let[o,a]=[r*t/n,(r+1)*t/n],l=i.roundAt(o);if(!l?.count||o>l.start+l.t.at(-1))return null;let c=l.place(o-l.start)[0];return e(l).range(c,Math.max(c,l.place(a-l.start)[0])+1)})}var vm=(i,e,t,n)=>Zt(i,e,t,n,{"font-size":11,fill:"var(--quiet)"}),Iv=i=>i?{"stroke-width":1.2}:{"stroke-width":3,"stroke-opacity":.7},Lv=i=>`var(--${i?"second":"first"})`,dd=class{constructor(e,t,n){this.pair=e;this.clock=n;let s=e.map(({head:l},c)=>M("li",{},bm(c),[l?.title,t[c]].filter(h=>h).join(" \xB7 "))),r="Line: predicted performance. Bar and dot: estimate with its 90\u202F% interval after a round. Cross: true.";this.element=M("section",{class:"s-compare","aria-label":"Comparison"},M("div",{},M("ul",{class:"w-legend"},...s),this.plots,M("p",{class:"w-quiet s-remark"},r)),this.table);let o=co(xC,()=>this.draw()),a=new ResizeObserver(()=>o.ask());a.observe(this.plots),this.stops.push(()=>a.disconnect(),o.stop,n.subscribe(()=>this.move()),...e.map(l=>l.onChange(()=>o.ask())))}pair;clock;element;plots=M("div",{class:"s-curves"});table=M("div",{class:"s-table",tabindex:0,role:"group","aria-label":"Differences"});stops=[];cursor=null;x=()=>0;destroy(){for(let e of this.stops)e()}draw(){let{clock:e,pair:t}=this,n=this.plots.clientWidth;if(!n)return;let s=Math.max(1,n-rr-ym);this.x=c=>rr+c/Math.max(e.duration,.001)*s;let r={force:20,performance:20+hd.force+yC},o=r.performance+hd.performance+Cv;this.cursor=ie("line",{y1:0,y2:o-Cv,stroke:"var(--ink)","stroke-width":1.5});let{times:a}=uu(0,e.duration,Math.max(2,s/90)),l=ie("svg",{width:n,height:o,role:"img","aria-label":"Force and performance of both recordings over time",click:({offsetX:c})=>e.seek((c-rr)/s*e.duration)},...this.drawForce(r.force,n,Math.round(s)),...this.drawPerformance(r.performance,n),...a.map(c=>vm(this.x(c),o-3,Je(c,0),"middle")),this.cursor);this.plots.replaceChildren(l),this.move(),this.table.replaceChildren(wC(bC(...t)))}move(){let e=this.x(this.clock.time).toFixed(1);this.cursor?.setAttribute("x1",e),this.cursor?.setAttribute("x2",e)}drawForce(e,t,n){let{clock:s,pair:r}=this,o=r.map(d=>_C(d,({normal:f})=>f,s.duration,n)),a=o.flat().filter(d=>d!==null),[l,c]=[Math.min(0,...a.map(([d])=>d)),Math.max(5,...a.map(([,d])=>d))],h=d=>e+hd.force*(1-(d-l)/(c-l)),u=o.map((d,f)=>{let p="";return d.forEach((x,g)=>{x&&(p+=`${p&&d[g-1]?"L":"M"}${rr+g} ${h(x[0]).toFixed(1)}V${h(x[1]).toFixed(1)}`)}),ie("path",{d:p,fill:"none",stroke:Lv(f),...Iv(f),"data-curve":`force-${To[f]}`})});return[...Dv("Force [N]",e,t,h,[0,c/2,c].map(Math.round),String),...u]}drawPerformance(e,t){let n=a=>e+hd.performance*(1-a),s=this.pair.flatMap((a,l)=>a.rounds.flatMap(c=>this.drawRound(c,l,n))),o=[...new Set(this.pair.map(({head:a})=>a?.task?.target).filter(a=>a!==void 0))].map(a=>ie("line",{x1:rr,x2:t-ym,y1:n(a),y2:n(a),stroke:"var(--target)","stroke-dasharray":"6 4"}));return[...Dv("Performance [%]",e,t,n,[0,.5,1],a=>String(100*a)),...o,...s]}drawRound({plan:e,start:t,end:n,length:s,interpreted:r,truth:o},a,l){let c=Lv(a),h=[];if(e.growth.length){let d=e.growth.map(([f,p])=>`${this.x(t+Math.min(f,s)).toFixed(1)} ${l(p).toFixed(1)}`);h.push(ie("path",{d:`M${d.join("L")}H${this.x(n).toFixed(1)}`,fill:"none",stroke:c,...Iv(a),"data-curve":`predicted-${To[a]}`}))}let u=this.x(n)-4-9*(1-a);if(r){let{mean:d,low:f,high:p}=r.estimate;h.push(ie("rect",{x:u-3,y:l(p),width:6,height:Math.max(1,l(f)-l(p)),fill:c,"fill-opacity":.3,stroke:c},ie("title",{},`${To[a]}: estimated ${Gt(r.estimate)}`)),ie("circle",{cx:u,cy:l(d),r:3,fill:c}))}if(typeof o?.performance=="number"){let d=l(o.performance);h.push(ie("path",{d:`M${u-4} ${d-4}l8 8m0 -8l-8 8`,stroke:c,"stroke-width":2,fill:"none"},ie("title",{},`${To[a]}: true ${_e(o.performance)}`)))}return h}};function Dv(i,e,t,n,s,r){return[vm(0,e-8,i,"start"),...s.flatMap(o=>[ie("line",{x1:rr,x2:t-ym,y1:n(o),y2:n(o),stroke:"var(--rule)","stroke-width":.6}),vm(rr-6,n(o)+4,r(o),"end")])]}function bm(i){return M("i",{class:`s-letter s-letter-${i?"second":"first"}`},To[i]??"")}var wC=i=>Mi(["",...To,"B \u2212 A"],i.map(({label:e,texts:t,by:n})=>M("tr",{"data-differs":String(n!==""&&n!==wn)},M("th",{scope:"row"},e),...t.map(s=>M("td",{title:s},s)),M("td",{},n||"same"))));var Nv=({rounds:i})=>new E(...i[0]?.plan.surface.pose.slice(0,3)??[]);function kv(i){let e=!1,t=i.map(({camera:n,recording:s})=>{let r=()=>{if(!(e||!n)){e=!0;for(let o of i){if(!o.camera||o.camera===n)continue;let a=Nv(o.recording).sub(Nv(s)),{target:l,eye:c}=n.view;o.camera.followLinked({target:l.add(a),eye:c.add(a)},n.asked)}e=!1}};return n?.controls.addEventListener("change",r),()=>n?.controls.removeEventListener("change",r)});return()=>{for(let n of t)n()}}var Cn=class extends Error{constructor(t,n){super(t.message);this.fault=t;this.status=n}fault;status},MC="The studio does not respond. If it has ended, start it again: wisch studio.";async function fd(i,e){let t;try{t=await fetch(i,{...e,cache:"no-store"})}catch{throw new Cn({message:MC},0)}if(t.ok)return t;throw new Cn(await SC(t),t.status)}async function SC(i){try{let e=await i.json();if(e.error)return e.error}catch{}return{message:`The studio refused the request with HTTP status ${i.status}.`}}var pd=async(i,e,t)=>await(await fd(i,{method:"POST",headers:{"content-type":"application/json"},body:JSON.stringify(e),signal:t??null})).json(),Ov=async i=>await(await fd(`api/overview?find=${encodeURIComponent(i)}`)).json(),Uv=async()=>await(await fd("api/vocabulary")).json();async function Fv(i,e){let t=await fd(`api/episodes/${encodeURIComponent(i)}/recording`);try{let n=new TextDecoder,s=t.body.getReader(),r="";for(let o=await s.read();!o.done;o=await s.read()){let a=n.decode(o.value,{stream:!0}),l=a.lastIndexOf(`
`);if(l>=0){for(let c of(r+a.slice(0,l)).split(`
`))e(c);r=""}r+=a.slice(l+1)}e(r+n.decode())}catch{throw new Cn({message:"The recording of this episode is damaged: it cannot be decompressed. To list damaged files, run: wisch memory verify."},0)}}var Bv=async(i,e,t)=>{let n={task:i,...e===null?{}:{seed:e},...t?{strategy:t}:{}};return(await pd("api/runs",n)).run},zv=i=>pd(`api/runs/${encodeURIComponent(i)}/stop`,{}),Vv=i=>pd(`api/runs/${encodeURIComponent(i)}/clear`,{});async function Gv(i,e){let t=await pd("api/ask",{query:i},e);if("error"in t)throw new Cn(t.error,200);return t}function _m(i,e){let t=new EventSource("api/overview/events");t.addEventListener("changed",i);let n=!1;t.addEventListener("open",()=>{e(!0),n&&i(),n=!1}),t.addEventListener("error",()=>{n=!0,e(!1),t.readyState===EventSource.CLOSED&&setTimeout(()=>_m(i,e),2e3)})}var Eo=class{constructor(e){this.actions=e}actions;element=M("section",{class:"s-stage","aria-label":"Recording"});panes=[];clock=null;stops=[];get shown(){return this.panes}get time(){return this.panes[0]?.view.clock.time??0}say(e,t,...n){this.clear(),this.element.append(M("div",{class:`s-said s-${e}`,role:e==="fault"?"alert":"status"},M("p",{},t),...n))}show(e,t){this.clear();let n=e.length>1;this.element.classList.toggle("s-two",n);let s=n?new _o:void 0;this.clock=s??null,this.panes=e.map((o,a)=>this.makePane(o,s,a)),s&&this.compare(s);let r=this.panes[0].view.clock;t!==null&&r.seek(t),this.stops.push(td(r,this.actions.rests))}compare(e){let[t,n]=this.panes;if(!t||!n)return;let s=new dd([t.recording,n.recording],[t.id,n.id],e);this.element.append(s.element),this.stops.push(()=>s.destroy(),kv(this.panes.map(({view:{stage:r},recording:o})=>({camera:r?.camera??null,recording:o}))))}makePane(e,t,n){let{recording:s}=e,r=new wm(e,!t,this.actions,l=>a.seek(l));t&&r.element.prepend(bm(n));let o=M("div",{class:"s-view"});this.element.append(M("div",{class:"s-pane"},r.element,r.story,o));let a=Ml(o,s,t?{compact:!0,clock:t}:{});return{...e,view:a,head:r,stop:vu(s,()=>r.show())}}closeStories(){for(let{head:e}of this.panes)e.toggle(!1)}focus(){let e=this.panes[0]?.view.element;e&&(e.tabIndex=-1,e.focus({preventScroll:!0}))}onConnectionChanged(){for(let{head:e}of this.panes)e.show()}clear(){for(let e of this.stops)e();this.stops=[];for(let{view:e,head:t,stop:n}of this.panes)n(),t.destroy(),e.destroy();this.clock?.destroy(),this.clock=null,this.panes=[],this.element.classList.remove("s-two"),this.element.replaceChildren()}},TC={connecting:"connecting \u2026",live:"live",reconnecting:"connection lost, reconnecting \u2026",ended:"",lost:"the run ended unexpectedly",gone:"the run no longer exists"},wm=class{constructor(e,t,n,s){this.source=e;this.whole=t;this.actions=n;let{recording:r,id:o}=e;this.wasLive=e.live!==null,this.summary=new Mo(r,s),this.story=M("div",{class:"s-story",hidden:!0},this.summary.element),this.stopButton=M("button",{class:"w-button s-stop",type:"button",hidden:!0,click:()=>{this.stopIt(o)}},"Stop"),this.storyButton=M("button",{class:"w-button",type:"button","aria-pressed":"false",click:()=>this.toggle(this.story.hidden)},"Summary"),this.element=M("header",{class:"s-head"},this.title,this.result,this.connection,this.kept,M("span",{class:"s-actions"},this.stopButton,this.storyButton,t&&n.compare&&M("button",{class:"w-button",type:"button",click:()=>n.compare?.()},"Compare"))),this.show()}source;whole;actions;element;story;title=M("h1",{});result=M("span",{class:"s-result"});connection=M("span",{class:"s-connection",role:"status"});kept=M("span",{class:"s-kept w-quiet"});stopButton;storyButton;summary;wasLive;toggle(e){this.story.hidden=!e,this.storyButton.setAttribute("aria-pressed",String(e))}async stopIt(e){this.stopButton.disabled=!0,ze(this.stopButton,"Stopping \u2026");try{await zv(e)}catch(t){this.stopButton.disabled=!1,ze(this.stopButton,"Stop"),ze(this.connection,String(t.message))}}show(){let{recording:e,live:t,id:n}=this.source;ze(this.title,e.head?.title??n);let s=e.rounds.findLast(h=>h.interpreted)?.interpreted,{state:r,text:o}=po(e),a=[];if(s){let{mean:h,low:u,high:d}=s.estimate;a.push(M("b",{title:"estimated performance, 90 % interval"},_e(h),M("small",{},` ${_e(u)} \u2013 ${_e(d)}`)))}(e.ended||r==="planned"||r==="logged")&&a.push(M("span",{class:"s-badge","data-state":r},o)),this.result.replaceChildren(...a);let l=t?.connection??"ended";this.connection.dataset.state=l,ze(this.connection,[TC[l],t?.message??""].filter(h=>h).join(": ")),this.stopButton.hidden=!t||l==="ended"||l==="lost"||l==="gone";let c=t?.episode??n;this.title.title=`${this.title.textContent} (${n})`,t&&l==="ended"&&this.kept.replaceChildren(this.actions.isKept(c)?M("a",{href:Ss({kind:"episode",ids:[c],time:null,query:null}),title:c},"kept as an episode"):"not kept as an episode"),this.wasLive&&e.ended&&(this.wasLive=!1,this.whole&&this.toggle(!0))}destroy(){this.summary.destroy()}};async function EC(i){let e=Uint8Array.from(atob(i),n=>n.charCodeAt(0)),t=new Blob([e]).stream().pipeThrough(new DecompressionStream("gzip"));return gi.parse(await new Response(t).text())}var Mm=class{constructor(e,t,n,s,r){this.answers=n;this.packed=s;let a=ed(n,{show:(c,h,u)=>{this.show(h,u)},clear:()=>{for(let{view:c}of this.stage.shown)c.show()}});e.classList.add("s-studio"),e.append(M("aside",{class:"s-side s-asked"},M("header",{class:"s-top"},M("h2",{class:"s-name"},"Answers of the memory"),r),M("section",{class:"s-ask"},M("pre",{class:"s-printed"},t),M("div",{class:"s-answers"},...a))),this.stage.element),Object.assign(window,{wisch:{stage:this.stage}});let l=[...Ms(n,null),...s.keys()].find(c=>s.has(c));l||_l(n)?this.show(null,l??null):this.stage.say("note","The answers name no episode that the page could show.")}answers;packed;stage=new Eo({rests:()=>{},compare:null,isKept:()=>!0});recordings=new Map;asked=0;async show(e,t){let n=++this.asked,s=Ms(this.answers,e),r=this.stage.shown.find(({id:l})=>t?l===t:s.includes(l)),o=t??r?.id??s.find(l=>this.packed.has(l))??s[0];if(!o)return;if(!r){let l=this.packed.get(o);if(l===void 0){this.stage.say("note",`This page holds no recording of episode ${o}.`);return}this.stage.say("wait","Loading \u2026");let c=this.recordings.get(o)??EC(l);this.recordings.set(o,c);try{let h=await c;if(n!==this.asked)return;this.stage.show([{id:o,recording:h,live:null}],null)}catch(h){n===this.asked&&this.stage.say("fault",`The recording of episode ${o} cannot be decompressed: ${String(h)}`);return}}let a=this.stage.shown.find(l=>l.id===o);a&&Qu(a.view,Ju(this.answers,e,o,a.recording))}};function Hv(i,e){let t=s=>document.getElementById(s)?.textContent??"",n=new Map([...document.querySelectorAll("script[data-episode]")].map(s=>[s.dataset.episode,s.textContent??""]));new Mm(i,t("query"),JSON.parse(t("answers")),n,e)}var AC=12,RC=/(?:([a-z]+):)?('?)([A-Za-z_][A-Za-z0-9_]*)$/;function CC(i){let e=[],t=new Set;for(let{name:s,arity:r,meaning:o}of i.predicates){let a=/^([^:]*?\)|[^:]*?): /.exec(o)?.[1]??"",l=a.startsWith(`${s}(`)?a:r?`${s}(`:s;t.has(l)||(t.add(l),e.push({name:`${s}/${r}`,kind:"predicate",meaning:o,text:l}))}let n=s=>({name:r,label:o,comment:a})=>({name:r,kind:s,meaning:a||o,text:PC(r)});e.push(...i.classes.map(n("class")),...i.properties.map(n("property")),...i.individuals.map(n("individual")));for(let s of i.builtins)e.push({name:s,kind:"Prolog",meaning:"predicate of standard Prolog",text:s.replace(/\/\d+$/,/\/0$/.test(s)?"":"(")});return e}function PC(i){let[e,t]=i.split(":");return/^[a-z][A-Za-z0-9_]*$/.test(t)?i:`${e}:'${t}'`}function IC(i,e,t){let n=RC.exec(e.slice(0,t));if(!n||/^[A-Z_]/.test(n[0])&&!n[1]&&!n[2]&&n[0].length<2)return null;let[s,r,,o]=n,a=o.toLowerCase(),l=i.flatMap(h=>{let[u,d]=h.name.includes(":")?h.name.split(":"):["",h.name];if(r&&u!==r)return[];let f=d.toLowerCase().indexOf(a);return f<0?[]:[{proposal:h,place:f?1:0,length:d.length}]});l.sort((h,u)=>h.place-u.place||Wv(h.proposal)-Wv(u.proposal)||h.length-u.length);let c=l.slice(0,AC).map(({proposal:h})=>h);return c.length?{from:t-s.length,found:c}:null}var Wv=({kind:i})=>["predicate","class","property","individual","Prolog"].indexOf(i),md=class{constructor(e){this.field=e;e.setAttribute("role","combobox"),e.setAttribute("aria-autocomplete","list"),e.setAttribute("aria-controls","s-proposals"),e.setAttribute("aria-expanded","false"),e.addEventListener("input",()=>this.updateProposals()),e.addEventListener("blur",()=>this.close()),e.addEventListener("keydown",t=>this.onKey(t))}field;list=M("ul",{class:"s-proposals",id:"s-proposals",role:"listbox","aria-label":"Completions",hidden:!0});all=[];now=null;chosen=0;setVocabulary(e){this.all=CC(e)}get isOpen(){return this.now!==null}close(){this.now=null,this.list.hidden=!0,this.field.setAttribute("aria-expanded","false"),this.field.removeAttribute("aria-activedescendant")}updateProposals(){let{value:e,selectionStart:t,selectionEnd:n}=this.field,s=/^[A-Za-z0-9_]/.test(e.slice(t));if(this.now=t===n&&!s?IC(this.all,e,t):null,!this.now)return this.close();this.chosen=0,this.draw()}draw(){let e=this.now.found.map(({name:t,kind:n,meaning:s},r)=>M("li",{id:`s-proposal-${r}`,role:"option","aria-selected":String(r===this.chosen),pointerdown:o=>{o.preventDefault(),this.chosen=r,this.accept()}},M("b",{},t),M("i",{},n),M("span",{},s)));this.list.replaceChildren(...e),this.list.hidden=!1,this.field.setAttribute("aria-expanded","true"),this.field.setAttribute("aria-activedescendant",`s-proposal-${this.chosen}`),e[this.chosen]?.scrollIntoView({block:"nearest"})}onKey(e){if(!this.now)return;let t=this.now.found.length;if(e.key==="ArrowDown")this.chosen=(this.chosen+1)%t;else if(e.key==="ArrowUp")this.chosen=(this.chosen+t-1)%t;else return e.key==="Tab"?this.accept(e):e.key==="Escape"?(e.preventDefault(),e.stopPropagation(),this.close()):void 0;e.preventDefault(),this.draw()}accept(e){e?.preventDefault();let{from:t,found:n}=this.now,{text:s}=n[this.chosen],{value:r,selectionStart:o}=this.field;this.field.setRangeText(s,t,o,"end");let a=this.field.selectionStart,l=r.slice(o);s.endsWith("(")&&l.startsWith("(")&&this.field.setRangeText("",a-1,a,"end"),this.close()}};var gd=class{constructor(e){this.actions=e;this.button=M("button",{class:"w-button s-primary",type:"button",click:()=>this.asking?this.asking.abort():void this.ask()},"Ask"),this.element=M("section",{class:"s-ask",hidden:!0},M("div",{class:"s-field"},this.field,this.completer.list),M("div",{class:"s-row"},this.button,M("span",{class:"w-quiet"},"Enter: ask; Shift + Enter: new line; Tab: complete")),this.fault,this.examples,this.result),this.field.addEventListener("input",()=>{this.fault.hidden=!0}),this.loadVocabulary()}actions;element;field=M("textarea",{class:"s-query",rows:3,spellcheck:"false",autocomplete:"off","aria-label":"Query in Prolog",placeholder:"low_performance_round(Round, P)",keydown:e=>{e.key!=="Enter"||e.shiftKey||e.isComposing||(e.preventDefault(),this.ask())}});completer=new md(this.field);fault=M("div",{class:"w-complaint s-fault",role:"alert",hidden:!0});chips=M("div",{class:"s-chips"});examples=M("details",{class:"s-examples",open:!0},M("summary",{},M("h2",{},"Example questions")),this.chips);result=M("div",{class:"s-answers","aria-live":"polite"});button;asking=null;async loadVocabulary(){try{let e=await Uv();this.completer.setVocabulary(e),this.chips.replaceChildren(...e.examples.map(({title:t,query:n},s)=>M("button",{class:"s-chip",type:"button",title:n,"data-example":s,click:()=>{this.field.value=n,this.ask()}},t)))}catch(e){this.complain({message:e.message})}}propose(e){this.asking?.abort(),this.asking=null,ze(this.button,"Ask"),this.completer.close(),this.field.value=e,this.fault.hidden=!0,this.examples.open=!1,this.actions.clear(),this.result.replaceChildren(M("p",{class:"s-remark"},"This query comes from the page's address. Press Ask to run it."))}async ask(){let e=this.field.value.trim();if(!e||this.asking)return;this.completer.close(),this.fault.hidden=!0;let t=new AbortController;this.asking=t,this.examples.open=!1,ze(this.button,"Cancel"),this.result.replaceChildren(M("p",{class:"w-quiet"},"Asking \u2026")),this.actions.asked(e);try{let n=await Gv(e,t.signal);this.result.replaceChildren(...ed(n,this.actions)),_l(n)?this.actions.show(n,null,null):this.actions.clear()}catch(n){if(this.asking!==t)return;this.result.replaceChildren(),t.signal.aborted||this.complain(n instanceof Cn?n.fault:{message:String(n)})}finally{this.asking===t&&(this.asking=null,ze(this.button,"Ask"))}}complain({message:e,offset:t,length:n,line:s,column:r}){let o=this.field.value.trim(),a=[M("p",{},e)];if(t!==void 0&&n!==void 0){let l=t+n;a.push(M("pre",{},o.slice(0,t),M("mark",{},o.slice(t,l)||"\u2038"),o.slice(l))),o.includes(`
`)&&a.push(M("p",{class:"w-quiet"},`line ${s}, column ${r}`)),this.field.value=o,document.activeElement===this.field&&this.field.setSelectionRange(t,l)}this.fault.replaceChildren(...a),this.fault.hidden=!1}};var Sm="M-2 -8h4v16h-4z",xd={HumanCollision:{name:Ys,shape:go.collision,colour:"collision"},HandGuiding:{name:"hand guiding",shape:go.hand,colour:"hand"},ContactLoss:{name:"contact loss",shape:go.event,colour:"event",hollow:!0},Overload:{name:"overload",shape:go.event,colour:"event"},ProtectiveStop:{name:"protective stop",shape:Sm,colour:"bad"},Stopped:{name:"stop on request or by an error",shape:Sm,colour:"bad"},EndedEarly:{name:"early end",shape:Sm,colour:"bad"}},$v=({events:i})=>Cl(i.flatMap(({class:e,count:t})=>Array.from({length:xd[e]?t:0},()=>xd[e].name)));function LC(i){let{seconds:e,round_starts:t}=i,n=c=>`${(100*Math.min(1,Math.max(0,c/e))).toFixed(2)}%`,s=(c,h)=>`${(100*Math.max(0,h-c)/e).toFixed(2)}%`,r=t.map((c,h)=>ie("rect",{x:n(c),y:3,width:s(c,t[h+1]??e),height:12,rx:2,class:"s-round"})),o=i.events.flatMap(c=>xd[c.class]?[{...c,...xd[c.class]}]:[]),a=o.map(({start:c,end:h,colour:u})=>ie("rect",{x:n(c),y:7.5,width:s(c,h),height:3,fill:`var(--${u})`})),l=o.map(({start:c,end:h,count:u,name:d,shape:f,colour:p,hollow:x})=>{let g=x?{fill:"var(--paper)",stroke:`var(--${p})`,"stroke-width":2}:{fill:`var(--${p})`,stroke:"var(--paper)"},m=`${u>1?`${u} \xD7 `:""}${d}, ${Je(c)} to ${Je(h)}`;return ie("svg",{x:n(c),y:9,overflow:"visible"},ie("path",{d:f,...g},ie("title",{},m)))});return ie("svg",{class:"s-time","aria-hidden":"true"},...r,...a,...l)}function DC({performance:i,low:e,high:t,target:n}){if(i===null)return null;let s=c=>`${(100*Math.min(1,Math.max(0,c))).toFixed(2)}%`,[r,o]=[e??i,t??i],a=`estimated ${Gt({mean:i,low:r,high:o})}${n===null?"":`, target ${_e(n)}`}`,l=(c,h,u,d)=>ie("line",{x1:s(c),x2:s(c),y1:h,y2:u,...d});return ie("svg",{class:"s-estimate",role:"img","aria-label":a},ie("title",{},a),ie("rect",{y:6,width:"100%",height:6,rx:3,class:"s-round"}),ie("rect",{x:s(r),y:4,width:s(o-r),height:10,rx:2,fill:"var(--estimated)","fill-opacity":.4}),l(i,2,16,{stroke:"var(--estimated)","stroke-width":2.5}),n!==null&&l(n,0,18,{stroke:"var(--target)","stroke-width":1.5,"stroke-dasharray":"3 2"}))}var Xv=i=>i.seconds>0?M("span",{class:"s-strip"},LC(i),DC(i)):null;var NC=200,yd=class{constructor(e){this.actions=e;let t;this.search=M("input",{class:"s-search",type:"search",placeholder:"Search episodes","aria-label":"Search episodes",autocomplete:"off",input:()=>{clearTimeout(t),t=setTimeout(()=>e.find(this.words),NC)}}),this.element=M("section",{class:"s-runs"},M("button",{class:"w-button s-primary",type:"button",click:()=>e.start()},"Start a task"),this.search,this.note,this.list,this.where)}actions;element;list=M("div",{class:"s-list"});search;where=M("p",{class:"s-where w-quiet"});note=M("div",{class:"s-picking",hidden:!0,role:"status"});overview=null;current=[];picking=null;get words(){return this.search.value.trim()}show(e){this.overview=e,this.draw()}mark(e){this.current=e,this.draw()}compareWith(e){this.picking=e,this.note.hidden=!e,this.note.replaceChildren(...e?[M("p",{},"Choose a run or episode to compare with."),M("button",{class:"w-button",type:"button",click:()=>this.compareWith(null)},"Cancel")]:[])}draw(){if(!this.overview)return;let{list:e,runs:t,memory:n}=this.overview;if(!jn(this.list,[e,t,this.current]))return;let s=document.activeElement?.dataset.key,r=[],o=t.filter(({state:a})=>a!=="ended");o.length&&r.push(M("h2",{},"Now"),M("ul",{},...o.map(a=>this.makeRun(a))));for(let[a,l]of UC(e.episodes))r.push(M("h2",{},a),M("ul",{},...l.map(c=>this.makeEpisode(c))));!e.episodes.length&&(this.words||!o.length)&&r.push(M("p",{class:"w-quiet"},this.words?"No matching episodes.":"There are no episodes yet. Start a task.")),e.total>e.episodes.length&&r.push(M("p",{class:"w-quiet"},`The list shows the newest ${e.episodes.length} of ${e.total} episodes. Use the search for older ones.`)),e.broken.length&&r.push(M("details",{class:"s-broken"},M("summary",{},`${e.broken.length} unreadable ${e.broken.length===1?"episode":"episodes"}`),...e.broken.map(a=>M("p",{},a)))),this.list.replaceChildren(...r),ze(this.where,`Memory: ${n}`),s&&this.list.querySelector(`[data-key="${CSS.escape(s)}"]`)?.focus()}makeLink(e,t,...n){let s=this.current.includes(t);return M("a",{href:Ss({kind:e,ids:[t],time:null,query:null}),"data-key":t,"aria-current":s?"true":null,click:r=>{!this.picking||r.ctrlKey||r.metaKey||r.shiftKey||(r.preventDefault(),this.actions.pick(t))}},...n)}makeRun({id:e,task:t,begun:n,state:s,message:r}){let o=s==="lost",a=o?"ended unexpectedly":`running${n?` since ${OC(n)}`:""}`;return M("li",{},this.makeLink("run",e,M("span",{class:"s-title"},M("i",{class:`s-dot${o?" s-dot-lost":""}`,"aria-hidden":"true"}),t),M("span",{class:"s-what"},M("span",{},a)),o&&r?M("span",{class:"s-what s-bad"},r):null),o&&M("button",{class:"w-button s-clear",type:"button",title:"Remove from the list","aria-label":`Remove ${t} from the list`,click:()=>{Vv(e).catch(()=>{})}},"\xD7"))}makeEpisode(e){let{performance:t,low:n,high:s,rounds:r}=e,o=[qv(new Date(1e3*e.begun)),`${r} ${r===1?"round":"rounds"}`,`${Be(e.seconds,0)} s`];e.events.length&&o.push($v(e)),e.has_recording||o.push("no recording"),e.verdict&&!e.met&&o.push(e.verdict);let a=n!==null&&s!==null?`, 90\u202F% interval ${_e(n)} to ${_e(s)}`:"";return M("li",{},this.makeLink("episode",e.id,M("span",{class:"s-title"},M("span",{},e.title),t===null?null:M("b",{title:`estimated performance${a}`},_e(t)),kC(e)),Xv(e),M("span",{class:"s-what"},o.join(" \xB7 "))))}};function kC({met:i,verdict:e,performance:t}){let n=Fp(i,e),s=n==="unmet"&&t===null?"none":n;return M("span",{class:"s-badge","data-state":s,title:e??""},{met:"met",unmet:"not met",unknown:"unknown",none:"\u2013"}[s])}var qv=i=>i.toLocaleTimeString([],{hour:"2-digit",minute:"2-digit"});function OC(i){let e=new Date(`${i.replace(" ","T").replace(/Z$/,"")}Z`);return Number.isNaN(e.getTime())?i:qv(e)}function UC(i){let e=new Map,t=s=>s.toLocaleDateString([],{weekday:"short",year:"numeric",month:"short",day:"numeric"}),n=t(new Date);for(let s of i){let r=t(new Date(1e3*s.begun));r===n&&(r="Today"),e.set(r,[...e.get(r)??[],s])}return e}var FC=4,BC=1e3,Ao=new Map;async function Yv(i){let e=Ao.get(i);Ao.delete(i);let t=e??await zC(i);return Zv(i,t),t}async function zC(i){let e=new gi;return await Fv(i,t=>e.applyLine(t)),e.close(),e}function Zv(i,e){Ao.set(i,e);let[t]=Ao.keys();Ao.size>FC&&t!==void 0&&Ao.delete(t)}var vd=class{constructor(e,t){this.id=e;this.changed=t;this.open()}id;changed;recording=new gi;connection="connecting";message="";lines=0;events=null;later;failures=0;open(){let e=new EventSource(`api/runs/${encodeURIComponent(this.id)}/stream?after=${this.lines}`);this.events=e,e.addEventListener("open",()=>{this.failures=0,this.set("live")}),e.addEventListener("message",({data:t,lastEventId:n})=>{let s=Number(n);s<=this.lines||(this.lines=s,this.recording.applyLine(t))}),e.addEventListener("end",({data:t})=>this.end(t)),e.addEventListener("error",()=>{if(this.set("reconnecting"),e.readyState===EventSource.CLOSED){if(this.failures++,this.failures>3){this.recording.close(),this.set("gone");return}this.later=setTimeout(()=>this.open(),BC*this.failures)}})}end(e){this.close();let t=JSON.parse(e);this.message=t.message,this.recording.close();let n=t.state==="ended";n&&this.recording.ended&&Zv(this.episode,this.recording),this.set(n?"ended":"lost")}get episode(){return this.recording.ended?.episode??this.id}set(e){this.connection=e,this.changed()}close(){clearTimeout(this.later),this.events?.close(),this.events=null}};var VC=["best","adaptive","grid","rrt","kde"],bd=class{constructor(e){this.begun=e;let t=M("form",{class:"s-own",submit:n=>{n.preventDefault(),this.start(this.path.value.trim())}},M("label",{},"Your own task file",this.path),M("button",{class:"w-button",type:"submit"},"Start"));this.element=M("dialog",{class:"s-dialog","aria-labelledby":"s-start-title"},M("header",{},M("h1",{id:"s-start-title"},"Start a task"),M("button",{class:"w-button",type:"button","aria-label":"Close",click:()=>this.element.close()},"\xD7")),this.fault,this.list,t,M("div",{class:"s-options"},M("label",{},"Seed",this.seed),M("label",{},"Strategy",this.strategy))),this.list.append(M("li",{},"Loading \u2026")),this.element.addEventListener("click",n=>{n.target===this.element&&this.element.close()}),this.element.addEventListener("input",()=>{this.fault.hidden=!0})}begun;element;list=M("ul",{class:"s-scenarios"});seed=M("input",{type:"number",min:0,step:1,placeholder:"from the task","aria-label":"Seed"});strategy=M("select",{class:"w-select","aria-label":"Strategy"},M("option",{value:""},"from the task"),...VC.map(e=>M("option",{value:e},e)));path=M("input",{type:"text",placeholder:"/path/to/task.toml","aria-label":"Task file on this machine",autocomplete:"off",spellcheck:"false"});fault=M("p",{class:"w-complaint",role:"alert",hidden:!0});busy=!1;open(){this.fault.hidden=!0,this.element.showModal()}setScenarios(e){jn(this.list,e)&&(this.list.replaceChildren(...e.map(({name:t,about:n})=>M("li",{},M("div",{},M("b",{},t),M("p",{},n)),M("button",{class:"w-button s-primary",type:"button","data-task":t,"aria-label":`Start ${t}`,click:()=>{this.start(t)}},"Start")))),e.length||this.list.append(M("li",{},"No shipped tasks were found.")))}async start(e){if(this.busy)return;let t=this.seed.value.trim();if(!e)return this.complain("The path is empty. Enter the path of a task file.");if(t&&!/^\d+$/.test(t))return this.complain("The seed must be a whole number, 0 or greater.");this.fault.hidden=!0,this.setBusy(!0);try{let n=await Bv(e,t?Number(t):null,this.strategy.value||null);this.element.close(),this.begun(n)}catch(n){this.complain(n instanceof Cn?n.message:String(n))}finally{this.setBusy(!1)}}setBusy(e){this.busy=e,this.element.toggleAttribute("data-busy",e);for(let t of this.element.querySelectorAll("button"))t.disabled=e}complain(e){this.fault.hidden=!1,ze(this.fault,e),this.fault.scrollIntoView({block:"nearest"})}};var Tl={kind:"home",ids:[],time:null,query:null},Tm=class{side;stage;ask;dialog;tabs;offline=M("p",{class:"s-offline",role:"status",hidden:!0},"The studio does not respond. If it has ended, start it again: wisch studio.");aside;known=null;place=Tl;live=[];waits=!1;opened=0;constructor(e,t){this.side=new yd({find:()=>{this.refresh()},start:()=>this.dialog.open(),pick:s=>this.compare(s)}),this.ask=new gd({show:(s,r,o)=>{this.show(s,r,o)},clear:()=>{for(let{view:s}of this.stage.shown)s.show()},asked:s=>this.keep({query:s})}),this.stage=new Eo({rests:s=>this.keep({time:s}),compare:()=>{this.open("runs"),this.side.compareWith(this.place.ids[0]??null)},isKept:s=>this.isKept(s)}),this.dialog=new bd(s=>{this.go({...Tl,kind:"run",ids:[s]}).then(()=>this.stage.focus())});let n=(s,r,o)=>M("button",{class:"w-button",type:"button","aria-pressed":"false",title:o,click:()=>this.isNarrow&&this.aside.dataset.open===s?this.open(null):this.open(s)},r);this.tabs={runs:n("runs","Runs","Runs and episodes"),ask:n("ask","Ask","Ask the memory ( / )")},this.aside=M("aside",{class:"s-side"},M("header",{class:"s-top"},M("h2",{class:"s-name"},"wisch studio"),this.tabs.runs,this.tabs.ask,t),this.offline,this.side.element,this.ask.element),e.classList.add("s-studio"),e.append(this.aside,this.stage.element,this.dialog.element),this.open("runs")}async begin(){addEventListener("hashchange",()=>{this.route()}),document.addEventListener("keydown",t=>{let n=t.target;t.key!=="/"||t.ctrlKey||t.metaKey||t.altKey||/^(INPUT|TEXTAREA|SELECT)$/.test(n.tagName)||(t.preventDefault(),this.open("ask"),this.ask.field.focus())}),_m(()=>{this.refresh()},t=>{this.offline.hidden=t}),Object.assign(window,{wisch:{studio:this,stage:this.stage}});let e=this.refresh();So(location.hash).kind!=="episode"&&await e,await this.route()}get isNarrow(){return matchMedia("(max-width: 760px)").matches}open(e){this.aside.dataset.open=e??"",this.side.element.hidden=e!=="runs",this.ask.element.hidden=e!=="ask";for(let t of["runs","ask"])this.tabs[t].setAttribute("aria-pressed",String(e===t))}async refresh(){try{this.known=await Ov(this.side.words),this.side.show(this.known),this.dialog.setScenarios(this.known.scenarios),this.stage.onConnectionChanged(),this.waits&&this.route()}catch(e){this.known||this.stage.say("fault",e.message)}}isKept(e){return this.known?.list.episodes.some(t=>t.id===e)??!1}async go(e){history.pushState(null,"",Ss(e)||location.pathname),await this.route()}keep(e){this.place={...this.place,...e},Rv(this.place)}async route(){let e=So(location.hash),{query:t}=e;e.kind==="home"&&(e={...this.first(),query:t});let n=this.place;this.place=e,!Av(n,e)||!this.stage.shown.length?await this.load(e):e.time!==null&&Math.abs(e.time-this.stage.time)>.06&&this.stage.shown[0].view.seek(e.time),t&&t!==n.query&&(this.open("ask"),this.ask.propose(t))}first(){let e=this.known?.runs.find(({state:n})=>n==="running");if(e)return{...Tl,kind:"run",ids:[e.id]};let t=this.known?.list.episodes.find(({has_recording:n})=>n);return t?{...Tl,kind:"episode",ids:[t.id]}:Tl}async load(e){let t=++this.opened;for(let n of this.live)n.close();if(this.live=[],this.side.compareWith(null),this.side.mark(e.ids),this.isNarrow&&e.kind!=="home"&&this.open(null),this.waits=e.kind==="home"&&!this.known,!this.waits){if(e.kind==="home"){this.stage.say("note","This memory has no runs yet.",M("button",{class:"w-button s-primary",type:"button",click:()=>this.dialog.open()},"Start a task"));return}this.stage.say("wait","Loading \u2026");try{let n=[];for(let s of e.ids)n.push(await this.source(s,e.kind==="run"));if(t!==this.opened)return;this.stage.show(n,e.time),document.title=`${n.map(({id:s,recording:r})=>r.head?.title??s).join(" | ")} \u2013 wisch studio`}catch(n){if(t!==this.opened)return;let s=n instanceof Cn?n.message:`The recording cannot be shown: ${String(n)}`;this.stage.say("fault",s,M("p",{class:"w-quiet"},"Queries about this episode still work."))}}}async source(e,t){if(t&&!this.isRun(e)&&await this.refresh(),this.isRun(e))return this.liveSource(e);try{return{id:e,recording:await Yv(e),live:null}}catch(n){if(!(n instanceof Cn)||n.status!==404)throw n;if(await this.refresh(),this.isRun(e))return this.liveSource(e);throw this.known&&!this.isKept(e)?new Cn({message:`There is no run or episode ${e}. A run that is stopped before its first motion is not kept.`},404):n}}isRun(e){return this.known?.runs.some(t=>t.id===e)??!1}liveSource(e){let t=new vd(e,()=>this.liveChanged(t));return this.live.push(t),{id:e,recording:t.recording,live:t}}liveChanged(e){this.stage.onConnectionChanged(),e.connection==="ended"&&this.refresh().then(()=>{this.place.kind!=="run"||this.place.ids[0]!==e.id||!this.isKept(e.episode)||(this.keep({kind:"episode",ids:[e.episode]}),this.side.mark(this.place.ids))})}compare(e){let t=this.place.ids[0];this.side.compareWith(null),!(!t||t===e)&&this.go({kind:"compare",ids:[t,e],time:this.stage.time,query:null})}async show(e,t,n){let s=Ms(e,t),r=this.stage.shown.find(({id:l})=>n?l===n:s.includes(l)),o=n??r?.id??s[0];if(!o)return;if(r)this.isNarrow&&this.open(null);else{let l={kind:"episode",ids:[o],time:null,query:this.place.query};history.pushState(null,"",Ss(l)),this.place=l,await this.load(l)}let a=this.stage.shown.find(l=>l.id===o);a&&(this.stage.closeStories(),Qu(a.view,Ju(e,t,o,a.recording)))}};function jv(i,e){new Tm(i,e).begin()}function Em(){let i=M("button",{class:"w-button w-theme",type:"button",click:()=>hx(fs()==="dark"?"light":"dark")}),e=()=>ze(i,fs()==="dark"?"Light":"Dark");return io(e),e(),i}function GC({clock:i}){td(i,e=>{let t=`#t=${e.toFixed(1)}`;if(!(location.hash===t||!location.hash&&e===0))try{history.replaceState(null,"",t)}catch{}}),addEventListener("hashchange",()=>{let{time:e}=So(location.hash);e!==null&&Math.abs(e-i.time)>.06&&i.seek(e)})}function HC(i){let e=gi.parse(document.getElementById("recording")?.textContent??"");i.classList.add("w-report");let t=new Mo(e,s=>{n.seek(s),n.element.scrollIntoView({block:"start"})},Em());i.append(t.element);let n=Ml(i,e);n.seek(So(location.hash).time??0),GC(n),Object.assign(window,{wisch:{recording:e,view:n,Recording:gi,mountView:Ml}})}ux();var Ro=document.getElementById("app"),{page:Kv}=document.documentElement.dataset;Ro&&Kv==="report"?HC(Ro):Ro&&Kv==="answers"?Hv(Ro,Em()):Ro&&jv(Ro,Em());})();
